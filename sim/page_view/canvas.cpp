#include "sim/page_view/canvas.h"

#include "textures/base/error.h"

#ifdef MOONTRACE_HAVE_IMGUI
#include <backends/imgui_impl_opengl2.h>
#include <fontconfig/fontconfig.h>
#include <imgui.h>

#include <cmath>
#include <mutex>
#endif

namespace moontrace {

#ifdef MOONTRACE_HAVE_IMGUI

namespace {

/// Dear ImGui has one current context for all threads.
std::mutex& OneAtATime() {
  static std::mutex mutex;
  return mutex;
}

/// DejaVu Sans, which Debian has nearly everywhere, or whatever the system takes for it. Empty:
/// none.
std::string FontFile() {
  FcPattern* wanted =
      FcNameParse(reinterpret_cast<const FcChar8*>("DejaVu Sans:fontformat=TrueType"));
  FcConfigSubstitute(nullptr, wanted, FcMatchPattern);
  FcDefaultSubstitute(wanted);
  FcResult result = FcResultNoMatch;
  FcPattern* found = FcFontMatch(nullptr, wanted, &result);
  std::string file, format;
  FcChar8* text = nullptr;
  if (found != nullptr && FcPatternGetString(found, FC_FILE, 0, &text) == FcResultMatch) {
    file = reinterpret_cast<const char*>(text);
  }
  if (found != nullptr && FcPatternGetString(found, FC_FONTFORMAT, 0, &text) == FcResultMatch) {
    format = reinterpret_cast<const char*>(text);
  }
  if (found != nullptr) FcPatternDestroy(found);
  FcPatternDestroy(wanted);
  return format == "TrueType" ? file : std::string();
}

/// Latin with its accents, Greek, Cyrillic, and the marks of print.
constexpr ImWchar kLetters[] = {0x20,   0x17f,  0x370,  0x3ff,  0x400, 0x4ff,
                                0x2010, 0x205e, 0x20ac, 0x20ac, 0};

ImU32 ColorOf(const Color& color, double alpha = 1) {
  return ImGui::ColorConvertFloat4ToU32(
      {static_cast<float>(color.red), static_cast<float>(color.green),
       static_cast<float>(color.blue), static_cast<float>(alpha)});
}

}  // namespace

struct Canvas::State {
  ImGuiContext* context = nullptr;
  ImFont* letters = nullptr;
  ImFont* big = nullptr;
  int width = 0, height = 0;
  std::unique_lock<std::mutex> turn{OneAtATime(), std::defer_lock};

  void Open(int text);
  ImFont* Font(bool is_big) const { return is_big ? big : letters; }
  ImVec2 At(glm::dvec2 p) const {
    return {static_cast<float>(p.x), static_cast<float>(height - p.y)};
  }
  std::vector<ImVec2> At(const std::vector<glm::dvec2>& points) const {
    std::vector<ImVec2> there;
    there.reserve(points.size());
    for (const glm::dvec2 p : points) there.push_back(At(p));
    return there;
  }
};

void Canvas::State::Open(int text) {
  const std::string file = FontFile();
  if (file.empty())
    throw LackError("no TrueType font for the view here: install fonts-dejavu-core");
  const std::unique_lock<std::mutex> lock(OneAtATime());
  context = ImGui::CreateContext();
  ImGui::SetCurrentContext(context);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = io.LogFilename = nullptr;  // it keeps nothing on disk
  io.DeltaTime = 1.0F / 30;
  const auto size = static_cast<float>(text);
  letters = io.Fonts->AddFontFromFileTTF(file.c_str(), size, nullptr, kLetters);
  big = io.Fonts->AddFontFromFileTTF(file.c_str(), std::round(size * static_cast<float>(kBig)),
                                     nullptr, kLetters);
  if (letters == nullptr || big == nullptr) {
    ImGui::DestroyContext(context);
    throw LackError(file + ": no TrueType font can be read there; install fonts-dejavu-core");
  }
  io.Fonts->Build();  // from now on letters have a width
  ImGui_ImplOpenGL2_Init();
}

Canvas::Canvas(int text) : state_(std::make_unique<State>()) { state_->Open(text); }

Canvas::~Canvas() {
  if (state_->turn.owns_lock()) End(false);  // a frame that was left by an exception
  const std::unique_lock<std::mutex> lock(OneAtATime());
  ImGui::SetCurrentContext(state_->context);
  ImGui_ImplOpenGL2_Shutdown();
  ImGui::DestroyContext(state_->context);
}

void Canvas::Begin(int width, int height, const CanvasMouse& mouse) {
  State& s = *state_;
  s.turn.lock();
  ImGui::SetCurrentContext(s.context);
  s.width = width;
  s.height = height;
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  io.MousePos = s.At(mouse.at);
  io.MouseDown[0] = mouse.left;
  io.MouseWheel = static_cast<float>(mouse.wheel);
  ImGui_ImplOpenGL2_NewFrame();
  ImGui::NewFrame();
}

void Canvas::End(bool draw) {
  if (draw) {
    ImGui::Render();
    ImGui_ImplOpenGL2_RenderDrawData(ImGui::GetDrawData());
  } else {
    ImGui::EndFrame();
  }
  state_->turn.unlock();
}

int Canvas::height() const { return state_->height; }

int Canvas::TextHeight(bool big) const {
  return static_cast<int>(std::ceil(state_->Font(big)->FontSize));
}

int Canvas::TextWidth(std::string_view text, bool big) const {
  const ImFont* font = state_->Font(big);
  const float width =
      font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.data(), text.data() + text.size()).x;
  return static_cast<int>(std::ceil(width));
}

void Canvas::Text(std::string_view text, int x, int y, bool big, const Color& color) {
  const ImFont* font = state_->Font(big);
  const glm::dvec2 top(x, y + TextHeight(big));
  ImGui::GetBackgroundDrawList()->AddText(font, font->FontSize, state_->At(top), ColorOf(color),
                                          text.data(), text.data() + text.size());
}

void Canvas::Fill(const PixelBox& box, const Color& color) {
  if (box.empty()) return;
  ImGui::GetBackgroundDrawList()->AddRectFilled(state_->At({box.x, box.y + box.height}),
                                                state_->At({box.x + box.width, box.y}),
                                                ColorOf(color));
}

void Canvas::Frame(const PixelBox& box, int thick, const Color& color) {
  Fill({box.x - thick, box.y - thick, box.width + 2 * thick, thick}, color);
  Fill({box.x - thick, box.y + box.height, box.width + 2 * thick, thick}, color);
  Fill({box.x - thick, box.y, thick, box.height}, color);
  Fill({box.x + box.width, box.y, thick, box.height}, color);
}

void Canvas::Line(const std::vector<glm::dvec2>& points, double thick, const Color& color) {
  // piece by piece: where a curve turns sharply a joined line would end in a spike
  for (std::size_t i = 1; i < points.size(); ++i) {
    ImGui::GetBackgroundDrawList()->AddLine(state_->At(points[i - 1]), state_->At(points[i]),
                                            ColorOf(color), static_cast<float>(thick));
  }
}

void Canvas::Shape(const std::vector<glm::dvec2>& corners, const Color& color, double alpha) {
  const std::vector<ImVec2> there = state_->At(corners);
  ImGui::GetBackgroundDrawList()->AddConvexPolyFilled(there.data(), static_cast<int>(there.size()),
                                                      ColorOf(color, alpha));
}

#else

struct Canvas::State {};

Canvas::Canvas(int /*text*/) {
  throw LackError("this build draws no view: install libimgui-dev and build again");
}
Canvas::~Canvas() = default;
void Canvas::Begin(int /*width*/, int /*height*/, const CanvasMouse& /*mouse*/) {}
void Canvas::End(bool /*draw*/) {}
int Canvas::height() const { return 0; }
int Canvas::TextHeight(bool /*big*/) const { return 1; }
int Canvas::TextWidth(std::string_view /*text*/, bool /*big*/) const { return 1; }
void Canvas::Text(std::string_view /*text*/, int /*x*/, int /*y*/, bool /*big*/,
                  const Color& /*color*/) {}
void Canvas::Fill(const PixelBox& /*box*/, const Color& /*color*/) {}
void Canvas::Frame(const PixelBox& /*box*/, int /*thick*/, const Color& /*color*/) {}
void Canvas::Line(const std::vector<glm::dvec2>& /*points*/, double /*thick*/,
                  const Color& /*color*/) {}
void Canvas::Shape(const std::vector<glm::dvec2>& /*corners*/, const Color& /*color*/,
                   double /*alpha*/) {}

#endif

}  // namespace moontrace
