#pragma once

/// @file
/// Moontrace's library for C++17 and later: moontrace.h with handles that close themselves and
/// refusals that are thrown. All of it is in this header and calls the C functions, so that it
/// keeps to their rules: units are SI, the frame is the page's (origin at its lower left corner, x
/// along the text, y up the page, z out of the paper), and any function may be called by any thread
/// at any time, as long as no thread assigns to or destroys an object that another one uses.
///
///     moontrace::Page page(moontrace::Text(moontrace::Script("moon"), "the moon"));
///     moontrace::Sample sample = page.SampleAt({0.02, 0.27});
///     page.Draw("page.svg");

#include <moontrace.h>

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace moontrace {
inline namespace library_1 {

/// A call that was refused; what() is one line.
class Error : public std::runtime_error {
 public:
  Error(int code, const char* message) : std::runtime_error(message), code_(code) {}
  /// One of the codes of moontrace.h, such as MOONTRACE_BAD_INPUT.
  int code() const noexcept { return code_; }

 private:
  int code_;
};

/// Throws Error for any answer but MOONTRACE_DONE.
inline void Require(int answer) {
  if (answer != MOONTRACE_DONE) throw Error(answer, moontrace_message());
}

/// A struct of the C interface, all zero but its size.
template <class Struct>
Struct Sized() {
  Struct sized{};
  sized.size = sizeof sized;
  return sized;
}

/// How a text is set: the fields of moontrace_style; zero and null are what is usual.
struct Style : moontrace_style {
  Style() : moontrace_style{} { size = sizeof(moontrace_style); }
};

/// How a page answers a tip: the fields of moontrace_surface; zeros are what is usual.
struct Surface : moontrace_surface {
  Surface() : moontrace_surface{} { size = sizeof(moontrace_surface); }
};

/// A script. Throws Error where moontrace_script_open refuses.
class Script {
 public:
  explicit Script(const std::string& name_or_path) {
    Require(moontrace_check(MOONTRACE_INTERFACE));
    moontrace_script* script = nullptr;
    Require(moontrace_script_open(name_or_path.c_str(), nullptr, &script));
    handle_.reset(script);
  }
  /// Its strings live as long as the script.
  moontrace_script_facts facts() const {
    auto facts = Sized<moontrace_script_facts>();
    Require(moontrace_script_describe(get(), &facts));
    return facts;
  }
  moontrace_script* get() const noexcept { return handle_.get(); }

 private:
  struct Close {
    void operator()(moontrace_script* script) const noexcept { moontrace_script_close(script); }
  };
  std::unique_ptr<moontrace_script, Close> handle_;
};

/// A text, set on pages. Throws Error where moontrace_text_open refuses.
class Text {
 public:
  Text(const Script& script, const std::string& words, const Style& style = {}) {
    moontrace_text* text = nullptr;
    Require(moontrace_text_open(script.get(), words.c_str(), &style, &text));
    handle_.reset(text);
  }
  moontrace_text_facts facts() const {
    auto facts = Sized<moontrace_text_facts>();
    Require(moontrace_text_describe(get(), &facts));
    return facts;
  }
  moontrace_text* get() const noexcept { return handle_.get(); }

 private:
  struct Close {
    void operator()(moontrace_text* text) const noexcept { moontrace_text_close(text); }
  };
  std::unique_ptr<moontrace_text, Close> handle_;
};

/// A point of the page [m].
struct Point {
  double x = 0, y = 0;
};
/// The surface at a point.
struct Sample {
  double displacement = 0;                ///< from the paper [m], below zero in grooves
  double gradient_x = 0, gradient_y = 0;  ///< [m/m]
};
/// A tip over the page, z above the flat paper [m].
struct Tip {
  double x = 0, y = 0, z = 0;
};
/// [N]
struct Force {
  double x = 0, y = 0, z = 0;
};
/// A sign on a page.
struct Letter {
  std::string sign;                              ///< its name
  Point at;                                      ///< left edge of its em box on the base line [m]
  std::size_t line = 0, word = 0;                ///< on the page, in the text
  std::size_t source_begin = 0, source_end = 0;  ///< bytes of the text
};

/// One page as a surface. Needs neither its text nor its script any more. Throws Error where
/// moontrace_page_open refuses.
class Page {
 public:
  explicit Page(const Text& text, std::size_t number = 0) {
    moontrace_page* page = nullptr;
    Require(moontrace_page_open(text.get(), number, &page));
    handle_.reset(page);
  }
  moontrace_page_facts facts() const {
    auto facts = Sized<moontrace_page_facts>();
    Require(moontrace_page_describe(get(), &facts));
    return facts;
  }
  std::vector<Letter> letters() const {
    std::vector<Letter> letters(facts().letters);
    for (std::size_t i = 0; i < letters.size(); ++i) {
      auto letter = Sized<moontrace_letter>();
      Require(moontrace_page_letter(get(), i, &letter));
      letters[i] = {letter.sign, {letter.x, letter.y}, letter.line,
                    letter.word, letter.source_begin,  letter.source_end};
    }
    return letters;
  }

  /// Throws Error for a point that is not finite, as all that follow.
  Sample SampleAt(Point point) const {
    double sample[3];
    Require(moontrace_sample(get(), point.x, point.y, sample));
    return {sample[0], sample[1], sample[2]};
  }
  /// The same at `count` points, faster; nothing is copied or allocated.
  void SamplesAt(const Point* points, std::size_t count, Sample* samples) const {
    if (count == 0) return;
    auto many = Sized<moontrace_samples>();
    many.count = count;
    many.x = &points->x;
    many.y = &points->y;
    many.x_step = many.y_step = sizeof(Point);
    many.displacement = &samples->displacement;
    many.gradient_x = &samples->gradient_x;
    many.gradient_y = &samples->gradient_y;
    many.displacement_step = many.gradient_x_step = many.gradient_y_step = sizeof(Sample);
    Require(moontrace_sample_many(get(), &many));
  }
  std::vector<Sample> SamplesAt(const std::vector<Point>& points) const {
    std::vector<Sample> samples(points.size());
    SamplesAt(points.data(), points.size(), samples.data());
    return samples;
  }

  /// The force on a tip; zero outside the surface.
  Force ForceOn(Tip tip, const Surface& surface = {}) const {
    double force[3];
    Require(moontrace_force(get(), &surface, tip.x, tip.y, tip.z, force));
    return {force[0], force[1], force[2]};
  }
  /// The same at `count` places, faster; nothing is copied or allocated.
  void ForcesOn(const Tip* tips, std::size_t count, Force* forces,
                const Surface& surface = {}) const {
    if (count == 0) return;
    auto many = Sized<moontrace_forces>();
    many.count = count;
    many.x = &tips->x;
    many.y = &tips->y;
    many.z = &tips->z;
    many.x_step = many.y_step = many.z_step = sizeof(Tip);
    many.force_x = &forces->x;
    many.force_y = &forces->y;
    many.force_z = &forces->z;
    many.force_x_step = many.force_y_step = many.force_z_step = sizeof(Force);
    Require(moontrace_force_many(get(), &surface, &many));
  }
  std::vector<Force> ForcesOn(const std::vector<Tip>& tips, const Surface& surface = {}) const {
    std::vector<Force> forces(tips.size());
    ForcesOn(tips.data(), tips.size(), forces.data(), surface);
    return forces;
  }

  /// Its picture in true size, .svg, .pdf or .png; `print`: with the letters in small print.
  void Draw(const std::string& path, bool print = false) const {
    Require(moontrace_page_draw(get(), path.c_str(), print ? MOONTRACE_PRINT : 0u));
  }

  moontrace_page* get() const noexcept { return handle_.get(); }

 private:
  struct Close {
    void operator()(moontrace_page* page) const noexcept { moontrace_page_close(page); }
  };
  std::unique_ptr<moontrace_page, Close> handle_;
};

/// A solid and where a page lies on it: the fields of moontrace_shape; zeros and null are what is
/// usual.
struct Shape : moontrace_shape {
  /// `kind` must outlive its use; sizes as moontrace_shape::half.
  explicit Shape(const char* of_kind, double first, double second = 0, double third = 0)
      : moontrace_shape{} {
    size = sizeof(moontrace_shape);
    kind = of_kind;
    half[0] = first;
    half[1] = second;
    half[2] = third;
  }
};

/// What a tip meets at a point of an object's frame.
struct ObjectSample {
  double displacement = 0;                                ///< along the smooth normal [m]
  double gradient_x = 0, gradient_y = 0, gradient_z = 0;  ///< in space [m/m]
  double height = 0;  ///< above the smooth surface, below zero inside [m]
};

/// A page on a solid; a Tip is a point of its frame. Needs its page no more. Throws Error where
/// moontrace_object_open refuses.
class Object {
 public:
  Object(const Page& page, const Shape& shape) {
    moontrace_object* object = nullptr;
    Require(moontrace_object_open(page.get(), &shape, &object));
    handle_.reset(object);
  }
  moontrace_object_facts facts() const {
    auto facts = Sized<moontrace_object_facts>();
    Require(moontrace_object_describe(get(), &facts));
    return facts;
  }
  /// Where a place over the page, z above it, lies in the object's frame. Throws Error for one that
  /// is not finite, as all that follow.
  Tip PlaceOf(Tip over_page) const {
    double place[3];
    Require(moontrace_object_place(get(), over_page.x, over_page.y, over_page.z, place));
    return {place[0], place[1], place[2]};
  }
  ObjectSample SampleAt(Tip point) const {
    double sample[5];
    Require(moontrace_object_sample(get(), point.x, point.y, point.z, sample));
    return {sample[0], sample[1], sample[2], sample[3], sample[4]};
  }
  Force ForceOn(Tip tip, const Surface& surface = {}) const {
    double force[3];
    Require(moontrace_object_force(get(), &surface, tip.x, tip.y, tip.z, force));
    return {force[0], force[1], force[2]};
  }
  /// The same at many places; nothing but the answer is allocated.
  std::vector<Force> ForcesOn(const std::vector<Tip>& tips, const Surface& surface = {}) const {
    std::vector<Force> forces(tips.size());
    if (tips.empty()) return forces;
    auto many = Sized<moontrace_forces>();
    many.count = tips.size();
    many.x = &tips.front().x;
    many.y = &tips.front().y;
    many.z = &tips.front().z;
    many.x_step = many.y_step = many.z_step = sizeof(Tip);
    many.force_x = &forces.front().x;
    many.force_y = &forces.front().y;
    many.force_z = &forces.front().z;
    many.force_x_step = many.force_y_step = many.force_z_step = sizeof(Force);
    Require(moontrace_object_force_many(get(), &surface, &many));
    return forces;
  }
  moontrace_object* get() const noexcept { return handle_.get(); }

 private:
  struct Close {
    void operator()(moontrace_object* object) const noexcept { moontrace_object_close(object); }
  };
  std::unique_ptr<moontrace_object, Close> handle_;
};

}  // namespace library_1
}  // namespace moontrace
