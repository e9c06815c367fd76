#include "sim/trial/line_walk.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <queue>
#include <utility>

namespace moontrace {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);
constexpr std::size_t kRingPlaces = 12;  // at which links may meet a ring (LinkPage)
constexpr double kHop = 0.5;             // grooves this near run into each other [w]
constexpr double kHopInFill = 1.5;       // within a filled area there is no wall [w]
constexpr double kHopCost = 3;           // of a hop, times its length: grooves are preferred

void Append(const std::vector<Piece>& pieces, double from, double to, std::vector<Piece>& path) {
  std::vector<Piece> parts;
  double begin = 0;
  const double low = std::min(from, to), high = std::max(from, to);
  for (const Piece& piece : pieces) {
    const double length = Length(piece);
    const double a = std::clamp(low - begin, 0.0, length);
    const double b = std::clamp(high - begin, 0.0, length);
    if (b - a > 1e-9)
      parts.push_back(from < to ? PartBetween(piece, a, b) : PartBetween(piece, b, a));
    begin += length;
  }
  if (from > to) std::reverse(parts.begin(), parts.end());
  path.insert(path.end(), parts.begin(), parts.end());
}

/// A groove that can be followed: a stroke or a link, with places along it.
struct Track {
  std::vector<Piece> pieces;
  double length = 0;
  bool forward_only = false;  ///< links, rings
  bool ring = false;
  bool fill = false;
  std::size_t from_glyph = 0, to_glyph = 0;  ///< equal for strokes
  std::size_t first = 0, count = 0;          ///< places
};

struct Place {
  glm::dvec2 p_P{0, 0};
  std::size_t track = 0;
  double s = 0;  ///< along the track [m]
};

struct Edge {
  std::size_t to = 0;
  double cost = 0;
};

/// All grooves of a page as a graph of places.
class GrooveGraph {
 public:
  GrooveGraph(const std::vector<IntendedStroke>& strokes, const GrooveLinks& links) {
    for (const IntendedStroke& stroke : strokes) {
      width_ = std::max(width_, stroke.width);
      AddStroke(stroke);
    }
    strokes_ = tracks_.size();
    for (const GrooveLink& link : links.links) {
      Track track{SpineOf(links, link), 0, true, false, false, link.from, link.to, 0, 0};
      AddTrack(std::move(track), 1);
    }
    edges_.resize(places_.size());
    cost_.assign(places_.size(), kUnreached);
    by_.resize(places_.size());
    for (std::size_t i = 0; i < tracks_.size(); ++i) JoinAlong(tracks_[i]);
    JoinStrokes();
    for (std::size_t i = strokes_; i < tracks_.size(); ++i) JoinLink(tracks_[i]);
  }

  /// Where a stroke begins to be traced if nothing leads to it.
  std::size_t StartOf(std::size_t stroke) const { return tracks_[stroke].first; }

  /// The path from a place to where a stroke may begin, and that place; kNone if there is none.
  std::size_t PathTo(std::size_t from, std::size_t stroke, std::vector<Piece>& path) {
    const Track& target = tracks_[stroke];
    const auto is_target = [&](std::size_t place) {
      return places_[place].track == stroke && (target.ring || place == target.first);
    };
    const std::size_t reached = Search(from, is_target);
    if (reached == kNone) return kNone;
    std::vector<std::size_t> steps = {reached};
    while (steps.back() != from) steps.push_back(by_[steps.back()]);
    std::reverse(steps.begin(), steps.end());
    Write(steps, path);
    return reached;
  }

  /// The stroke from a place of it, and the place where that ends.
  std::size_t Trace(std::size_t from, std::vector<Piece>& trace) const {
    const Track& track = tracks_[places_[from].track];
    if (track.length <= 0) return from;
    if (!track.ring) {
      trace = track.pieces;
      return track.first + track.count - 1;
    }
    const double s = places_[from].s;
    Append(track.pieces, s, track.length, trace);
    Append(track.pieces, 0, s, trace);
    return from;
  }

 private:
  void AddStroke(const IntendedStroke& stroke) {
    Track track;
    track.pieces = stroke.spine_P;
    track.from_glyph = track.to_glyph = stroke.glyph;
    track.fill = stroke.kind == StrokeKind::kFill;
    const Piece &first = track.pieces.front(), &last = track.pieces.back();
    const bool closed = glm::distance(moontrace::StartOf(first), EndOf(last)) < 1e-2 * stroke.width;
    track.ring = stroke.kind == StrokeKind::kStroke && closed &&
                 glm::dot(TangentAt(first, 0), TangentAt(last, Length(last))) > 0.94;
    track.forward_only = track.ring;
    AddTrack(std::move(track), stroke.kind == StrokeKind::kStroke ? kRingPlaces : 1);
  }

  void AddTrack(Track track, std::size_t parts) {
    track.length = Length(track.pieces);
    track.first = places_.size();
    const double spacing = width_ / 4 * static_cast<double>(parts);
    const auto steps = parts * static_cast<std::size_t>(std::ceil(track.length / spacing));
    for (std::size_t i = 0; i <= steps; ++i) {
      if (track.ring && i == steps) break;  // the end is the start
      const double s =
          steps == 0 ? 0 : track.length * static_cast<double>(i) / static_cast<double>(steps);
      places_.push_back({PointAlong(track.pieces, s), tracks_.size(), s});
    }
    track.count = places_.size() - track.first;
    tracks_.push_back(std::move(track));
  }

  double Distance(std::size_t a, std::size_t b) const {
    return glm::distance(places_[a].p_P, places_[b].p_P);
  }

  void JoinAlong(const Track& track) {
    const double step = track.length / static_cast<double>(std::max<std::size_t>(
                                           track.ring ? track.count : track.count - 1, 1));
    for (std::size_t i = 0; i + 1 < track.count; ++i) {
      edges_[track.first + i].push_back({track.first + i + 1, step});
      if (!track.forward_only) edges_[track.first + i + 1].push_back({track.first + i, step});
    }
    if (track.ring) edges_[track.first + track.count - 1].push_back({track.first, step});
  }

  void JoinStrokes() {
    for (std::size_t a = 0; a < strokes_; ++a) {
      for (std::size_t b = a + 1; b < strokes_; ++b) {
        if (tracks_[a].from_glyph != tracks_[b].from_glyph) break;  // letters follow each other
        const bool fill = tracks_[a].fill || tracks_[b].fill;
        JoinNear(tracks_[a], tracks_[b], (fill ? kHopInFill : kHop) * width_);
      }
    }
  }

  void JoinNear(const Track& a, const Track& b, double most) {
    for (std::size_t i = a.first; i < a.first + a.count; ++i) {
      for (std::size_t j = b.first; j < b.first + b.count; ++j) {
        const double distance = Distance(i, j);
        if (distance > most) continue;
        edges_[i].push_back({j, kHopCost * distance});
        edges_[j].push_back({i, kHopCost * distance});
      }
    }
  }

  void JoinLink(const Track& link) {
    const std::size_t last = link.first + link.count - 1;
    const std::size_t from = Nearest(link.from_glyph, link.first);
    const std::size_t to = Nearest(link.to_glyph, last);
    if (from != kNone) edges_[from].push_back({link.first, Distance(from, link.first)});
    if (to != kNone) edges_[last].push_back({to, Distance(last, to)});
  }

  /// The place on a glyph's strokes that is nearest to a place of a link.
  std::size_t Nearest(std::size_t glyph, std::size_t place) const {
    std::size_t nearest = kNone;
    double least = kHop * width_;
    // strokes are in the order of their glyphs
    const auto begin = std::partition_point(
        tracks_.begin(), tracks_.begin() + static_cast<std::ptrdiff_t>(strokes_),
        [glyph](const Track& track) { return track.from_glyph < glyph; });
    for (auto track = begin; track != tracks_.begin() + static_cast<std::ptrdiff_t>(strokes_) &&
                             track->from_glyph == glyph;
         ++track) {
      for (std::size_t i = track->first; i < track->first + track->count; ++i) {
        if (Distance(i, place) >= least) continue;
        least = Distance(i, place);
        nearest = i;
      }
    }
    return nearest;
  }

  template <class IsTarget>
  std::size_t Search(std::size_t from, IsTarget is_target) {
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (const std::size_t place : touched_) cost_[place] = kUnreached;
    touched_ = {from};
    cost_[from] = 0;
    queue.push({0, from});
    while (!queue.empty()) {
      const auto [cost, place] = queue.top();
      queue.pop();
      if (cost > cost_[place]) continue;
      if (is_target(place)) return place;
      for (const Edge& edge : edges_[place]) {
        if (cost + edge.cost >= cost_[edge.to]) continue;
        cost_[edge.to] = cost + edge.cost;
        by_[edge.to] = place;
        touched_.push_back(edge.to);
        queue.push({cost + edge.cost, edge.to});
      }
    }
    return kNone;
  }

  /// Runs of steps along one track become parts of it, hops become lines.
  void Write(const std::vector<std::size_t>& steps, std::vector<Piece>& path) const {
    for (std::size_t i = 0; i + 1 < steps.size();) {
      const Place& here = places_[steps[i]];
      const Place& next = places_[steps[i + 1]];
      if (here.track != next.track) {
        if (glm::distance(here.p_P, next.p_P) > 1e-9) path.push_back(Line{here.p_P, next.p_P});
        ++i;
        continue;
      }
      const Track& track = tracks_[here.track];
      std::size_t end = i + 1;
      double s = next.s;
      const bool wraps = track.ring && next.s < here.s;
      if (wraps) s = track.length;
      while (!wraps && end + 1 < steps.size() && places_[steps[end + 1]].track == here.track &&
             (places_[steps[end + 1]].s - s) * (s - here.s) > 0) {
        s = places_[steps[++end]].s;
      }
      Append(track.pieces, here.s, s, path);
      i = end;
    }
  }

  static constexpr double kUnreached = std::numeric_limits<double>::infinity();
  double width_ = 0;
  std::size_t strokes_ = 0;    ///< of the tracks; then come links
  std::vector<Track> tracks_;  ///< one for each stroke, in the page's order
  std::vector<Place> places_;
  std::vector<std::vector<Edge>> edges_;
  std::vector<double> cost_;
  std::vector<std::size_t> by_, touched_;
};

std::vector<Piece> TraceOf(const IntendedStroke& stroke) {
  return Length(stroke.spine_P) > 0 ? stroke.spine_P : std::vector<Piece>();
}

}  // namespace

std::vector<Walk> SeparateWalks(const std::vector<IntendedStroke>& strokes) {
  std::vector<Walk> walks;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    if (!strokes[i].spine_P.empty()) walks.push_back({{{}, TraceOf(strokes[i]), i}});
  }
  return walks;
}

std::vector<Walk> LinkedWalks(const std::vector<IntendedStroke>& strokes, const TextPage& page,
                              const GrooveLinks& links) {
  GrooveGraph graph(strokes, links);
  std::vector<Walk> walks;
  std::size_t place = kNone;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const bool goes_on =
        i > 0 && page.glyphs[strokes[i].glyph].line == page.glyphs[strokes[i - 1].glyph].line;
    WalkStep step;
    step.stroke = i;
    const std::size_t reached = goes_on ? graph.PathTo(place, i, step.path_P) : kNone;
    if (reached == kNone) walks.emplace_back();
    place = graph.Trace(reached == kNone ? graph.StartOf(i) : reached, step.trace_P);
    walks.back().push_back(std::move(step));
  }
  return walks;
}

std::vector<Walk> WalksOf(const std::vector<IntendedStroke>& strokes, const TextPage& page,
                          const GrooveLinks& links) {
  return links.links.empty() ? SeparateWalks(strokes) : LinkedWalks(strokes, page, links);
}

}  // namespace moontrace
