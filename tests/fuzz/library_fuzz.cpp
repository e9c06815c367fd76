// Any bytes as calls of the C interface, one after the other: whatever is passed, closed or mixed
// up, each answers by a code, with a sentence if it refuses. Only what no library can see is kept
// right: addresses and the lengths of what lies there.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "sim/library/moontrace.h"

namespace {

void Require(bool holds) {
  if (!holds) std::abort();
}

/// Values from bytes; zeros behind their end.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  bool empty() const { return size_ == 0; }
  template <class Value>
  Value Take() {
    Value value{};
    const std::size_t count = std::min(sizeof value, size_);
    std::memcpy(&value, data_, count);
    data_ += count;
    size_ -= count;
    return value;
  }
  std::string Text() {
    const std::size_t count = std::min<std::size_t>(Take<std::uint8_t>() % 48, size_);
    std::string text(reinterpret_cast<const char*>(data_), count);
    data_ += count;
    size_ -= count;
    return text;
  }
  /// Mostly on the page, at times any bits.
  double Number() {
    const auto kind = Take<std::uint8_t>();
    return kind < 16 ? Take<double>() : 0.001 * kind;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

void Answered(int code) {
  Require(code >= MOONTRACE_DONE && code <= MOONTRACE_LACKING && code != MOONTRACE_FAULT);
  if (code != MOONTRACE_DONE) Require(moontrace_message()[0] != '\0');
}

constexpr std::size_t kHandles = 4;

/// Handles of every kind, open, closed, null or of any bits; each may be given as each.
class Caller {
 public:
  explicit Caller(Bytes bytes) : bytes_(bytes) {}
  ~Caller() {
    for (void* handle : handles_) {  // all but one refuse
      moontrace_script_close(static_cast<moontrace_script*>(handle));
      moontrace_text_close(static_cast<moontrace_text*>(handle));
      moontrace_page_close(static_cast<moontrace_page*>(handle));
      moontrace_object_close(static_cast<moontrace_object*>(handle));
    }
  }
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;

  void Run() {
    for (int calls = 0; calls < 24 && !bytes_.empty(); ++calls) Call();
  }

 private:
  void*& Handle() { return handles_[bytes_.Take<std::uint8_t>() % kHandles]; }
  template <class Kind>
  Kind* HandleAs() {
    return static_cast<Kind*>(Handle());
  }
  /// A handle that is opened anew is closed before, as whatever it is.
  template <class Kind>
  Kind** Into(void*& handle) {
    moontrace_script_close(static_cast<moontrace_script*>(handle));
    moontrace_text_close(static_cast<moontrace_text*>(handle));
    moontrace_page_close(static_cast<moontrace_page*>(handle));
    moontrace_object_close(static_cast<moontrace_object*>(handle));
    handle = nullptr;
    return reinterpret_cast<Kind**>(&handle);
  }
  /// A struct of a size that mostly is its own, and any other within its room.
  template <class Struct>
  void Size(Struct& given) {
    const auto byte = bytes_.Take<std::uint8_t>();
    given.size = byte < 224 ? sizeof given : byte;
  }

  void Open() {
    const auto what = bytes_.Take<std::uint8_t>();
    if (what % 3 == 0) {
      const char* const names[] = {"moon", "shapes", "braille", "", "a/b", "hershey:"};
      Answered(
          moontrace_script_open(names[what / 3 % 6], nullptr, Into<moontrace_script>(Handle())));
    } else if (what % 3 == 1) {
      const moontrace_script* script = HandleAs<moontrace_script>();
      void*& to = Handle();
      OpenText(script, to);
    } else {
      const moontrace_text* set = HandleAs<moontrace_text>();
      moontrace_page* page = nullptr;
      Answered(moontrace_page_open(set, what / 3 % 3, &page));
      void*& to = Handle();
      *Into<moontrace_page>(to) = page;
    }
  }

  void OpenText(const moontrace_script* script, void*& to) {
    // as long as any size that Size gives
    struct {
      moontrace_style style;
      std::array<std::uint8_t, 128> more;
    } room{};
    moontrace_style& style = room.style;
    Size(style);
    const std::string text = bytes_.Text(), word = bytes_.Text();
    const auto flags = bytes_.Take<std::uint8_t>();
    style.embossed = flags & 1;
    style.rules = flags >> 1 & 1;
    style.raised_margin = flags >> 2 & 1;
    style.structure = flags >> 3 & 3;
    style.sheet = flags & 32 ? word.c_str() : "90x60";
    if (flags & 64) style.only = word.c_str();
    if (flags & 128) style.h_form = word.c_str();
    const auto words = bytes_.Take<std::uint8_t>();
    const char* const lines[] = {nullptr, "vertical", "alternate", word.c_str()};
    const char* const links[] = {nullptr, "letters", "words", word.c_str()};
    style.lines = lines[words & 3];
    style.links = links[words >> 2 & 3];
    if (words & 16) style.table = word.c_str();
    if (words & 32) style.hyphenation = word.c_str();
    double* const numbers[] = {&style.letter_size, &style.width,      &style.depth,
                               &style.rounding,    &style.letter_gap, &style.word_gap,
                               &style.line_pitch,  &style.margin,     &style.grade};
    for (double* number : numbers) {
      if (bytes_.Take<std::uint8_t>() & 1) *number = bytes_.Number();
    }
    moontrace_text* set = nullptr;
    Answered(moontrace_text_open(script, text.c_str(), &style, &set));
    *Into<moontrace_text>(to) = set;
  }

  void Describe() {
    struct {
      union {
        moontrace_script_facts script;
        moontrace_text_facts text;
        moontrace_page_facts page;
        moontrace_letter letter;
      };
      std::array<std::uint8_t, 256> more;
    } room{};
    switch (bytes_.Take<std::uint8_t>() % 4) {
      case 0:
        Size(room.script);
        return Answered(moontrace_script_describe(HandleAs<moontrace_script>(), &room.script));
      case 1:
        Size(room.text);
        return Answered(moontrace_text_describe(HandleAs<moontrace_text>(), &room.text));
      case 2:
        Size(room.page);
        return Answered(moontrace_page_describe(HandleAs<moontrace_page>(), &room.page));
      default:
        Size(room.letter);
        return Answered(moontrace_page_letter(HandleAs<moontrace_page>(),
                                              bytes_.Take<std::uint8_t>(), &room.letter));
    }
  }

  void Sample() {
    double three[3];
    const double x = bytes_.Number(), y = bytes_.Number(), z = bytes_.Number();
    Answered(moontrace_sample(HandleAs<moontrace_page>(), x, y, three));
    moontrace_surface surface{};
    Size(surface);
    if (surface.size > sizeof surface) surface.size = sizeof surface;
    surface.law = bytes_.Take<std::uint8_t>() % 3;
    surface.stiffness = bytes_.Number();
    surface.force_cap = bytes_.Number();
    const int answer = moontrace_force(HandleAs<moontrace_page>(), &surface, x, y, z, three);
    Answered(answer);
    if (answer == MOONTRACE_DONE) Require(three[2] == three[2]);
  }

  /// Arrays that lie anyhow in a room that holds them.
  void Many() {
    const std::size_t count = bytes_.Take<std::uint8_t>();
    std::vector<char> in(8 * 2 * 512), out(8 * 2 * 512 * 3);
    for (std::size_t i = 0; i < 32; ++i) {
      const double number = bytes_.Number();
      for (std::size_t k = 0; k + 8 <= in.size() - 8; k += 8 * 32) {
        std::memcpy(in.data() + k + 8 * i, &number, sizeof number);
      }
    }
    const auto step = [&] { return static_cast<std::ptrdiff_t>(bytes_.Take<std::int8_t>() % 17); };
    const auto from = [](std::vector<char>& room, std::ptrdiff_t by) {
      return reinterpret_cast<double*>(room.data() + room.size() / 2 + (by & 1));
    };
    moontrace_samples samples{};
    samples.size = sizeof samples;
    samples.count = count;
    samples.x_step = step();
    samples.x = from(in, samples.x_step);
    samples.y_step = step();
    samples.y = samples.x + 1;
    samples.displacement_step = step();
    samples.displacement = from(out, samples.displacement_step);
    samples.gradient_x_step = step();
    samples.gradient_x = samples.gradient_x_step & 2 ? samples.displacement + 1 : nullptr;
    samples.gradient_y_step = samples.displacement_step;
    samples.gradient_y = samples.displacement + 2;
    Answered(moontrace_sample_many(HandleAs<moontrace_page>(), &samples));
    moontrace_forces forces{};
    forces.size = sizeof forces;
    forces.count = count;
    forces.x = samples.x;
    forces.x_step = samples.x_step;
    forces.y = samples.y;
    forces.y_step = samples.y_step;
    forces.z = from(in, 1);
    forces.z_step = step();
    forces.force_z = samples.displacement;
    forces.force_z_step = samples.displacement_step;
    Answered(moontrace_force_many(HandleAs<moontrace_page>(), nullptr, &forces));
  }

  /// A solid is made of a page, asked, and kept or closed.
  void UseObject() {
    const char* const kinds[] = {"plane",   "box",       "cylinder", "sphere",
                                 "capsule", "ellipsoid", "cone"};
    const char* const faces[] = {nullptr, "top", "front", "left", "round", "inside"};
    const auto what = bytes_.Take<std::uint8_t>();
    moontrace_shape shape{};
    Size(shape);
    if (shape.size > sizeof shape) shape.size = sizeof shape;
    shape.kind = kinds[what % 7];
    shape.face = faces[what / 7 % 6];
    shape.corner = what >> 6;
    for (double& half : shape.half) half = bytes_.Number();
    shape.u = bytes_.Number();
    shape.v = bytes_.Number();
    shape.turn = bytes_.Number();
    const moontrace_page* page = HandleAs<moontrace_page>();
    moontrace_object* object = nullptr;
    Answered(moontrace_object_open(page, &shape, &object));
    void*& to = Handle();
    *Into<moontrace_object>(to) = object;
    AskObject(HandleAs<moontrace_object>());
  }

  void AskObject(const moontrace_object* object) {
    double five[5], three[3];
    const double x = bytes_.Number(), y = bytes_.Number(), z = bytes_.Number();
    Answered(moontrace_object_place(object, x, y, z, three));
    const int answer = moontrace_object_sample(object, x, y, z, five);
    Answered(answer);
    if (answer == MOONTRACE_DONE) Require(five[0] == five[0] && five[4] == five[4]);
    Answered(moontrace_object_force(object, nullptr, x, y, z, three));
    moontrace_object_samples samples{};
    samples.size = sizeof samples;
    samples.count = 1;
    samples.x = samples.y = samples.z = &x;
    samples.height = five;
    Answered(moontrace_object_sample_many(object, &samples));
    moontrace_object_facts facts{};
    Size(facts);
    if (facts.size > sizeof facts) facts.size = sizeof facts;
    Answered(moontrace_object_describe(object, &facts));
  }

  void Call() {
    switch (bytes_.Take<std::uint8_t>() % 9) {
      case 8:
        return UseObject();
      case 0:
      case 1:
      case 2:
        return Open();
      case 3:
        return Describe();
      case 4:
        return Sample();
      case 5:
        return Many();
      case 6:
        Answered(moontrace_page_close(HandleAs<moontrace_page>()));
        return Answered(moontrace_text_close(HandleAs<moontrace_text>()));
      default: {
        Answered(moontrace_check(bytes_.Take<std::uint8_t>()));
        void*& any = Handle();
        Into<moontrace_page>(any);
        any = bytes_.Take<void*>();  // bits that nothing gave out, or that something did
        return;
      }
    }
  }

  Bytes bytes_;
  std::array<void*, kHandles> handles_{};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Caller({data, size}).Run();
  return 0;
}
