#include "lessons/documents/html_tree.h"

#include "textures/base/error.h"
#include "textures/base/text_file.h"

#ifdef MOONTRACE_HAVE_GUMBO
#include <gumbo.h>

#include <memory>
#endif

namespace moontrace {

#ifdef MOONTRACE_HAVE_GUMBO

namespace {

struct DestroyOutput {
  void operator()(GumboOutput* output) const {
    gumbo_destroy_output(&kGumboDefaultOptions, output);
  }
};
using Output = std::unique_ptr<GumboOutput, DestroyOutput>;

Output Parsed(std::string_view html) {
  GumboOptions options = kGumboDefaultOptions;
  options.max_errors = 0;
  return Output(gumbo_parse_with_options(&options, html.data(), html.size()));
}

const GumboVector* ChildrenOf(const GumboNode& node) {
  switch (node.type) {
    case GUMBO_NODE_DOCUMENT:
      return &node.v.document.children;
    case GUMBO_NODE_ELEMENT:
    case GUMBO_NODE_TEMPLATE:
      return &node.v.element.children;
    case GUMBO_NODE_TEXT:
    case GUMBO_NODE_CDATA:
    case GUMBO_NODE_COMMENT:
    case GUMBO_NODE_WHITESPACE:
      return nullptr;
  }
  return nullptr;
}

std::string NameOf(const GumboElement& element) {
  if (element.tag != GUMBO_TAG_UNKNOWN) return gumbo_normalized_tagname(element.tag);
  GumboStringPiece name = element.original_tag;
  gumbo_tag_from_original_text(&name);
  return LowerCase(std::string_view(name.data, name.length));
}

void Open(const GumboElement& element, MarkupSink& sink, MarkupAttributes& attributes) {
  attributes.clear();
  for (unsigned i = 0; i < element.attributes.length; ++i) {
    const auto& attribute = *static_cast<const GumboAttribute*>(element.attributes.data[i]);
    std::string_view name = attribute.name;
    if (attribute.attr_namespace == GUMBO_ATTR_NAMESPACE_XLINK) name = "xlink:href";
    attributes.Add(name, attribute.value);
  }
  sink.Open(NameOf(element), attributes);
}

}  // namespace

bool CanReadHtml() { return true; }

void ReadHtmlMarkup(std::string_view html, MarkupSink& sink) {
  const Output output = Parsed(html);
  MarkupAttributes attributes;
  // Without recursion: the way back is in the nodes.
  const GumboNode* node = output->root;
  for (bool down = true; node != nullptr;) {
    const GumboVector* children = ChildrenOf(*node);
    if (down && children != nullptr) Open(node->v.element, sink, attributes);
    if (down && children == nullptr && node->type != GUMBO_NODE_COMMENT)
      sink.Text(node->v.text.text);
    if (down && children != nullptr && children->length > 0) {
      node = static_cast<const GumboNode*>(children->data[0]);
      continue;
    }
    if (children != nullptr) sink.Close();
    if (node == output->root) return;
    const GumboNode* parent = node->parent;
    const GumboVector& siblings = *ChildrenOf(*parent);
    const std::size_t next = node->index_within_parent + 1;
    down = next < siblings.length;
    node = down ? static_cast<const GumboNode*>(siblings.data[next]) : parent;
  }
}

std::optional<std::string> NamedCharacters(std::string_view name) {
  std::string written = "<body>&";
  written.append(name);
  written += ';';
  const Output output = Parsed(written);
  const GumboNode* node = output->root;
  while (node != nullptr && ChildrenOf(*node) != nullptr) {
    const GumboVector& children = *ChildrenOf(*node);
    node = children.length == 0 ? nullptr
                                : static_cast<const GumboNode*>(children.data[children.length - 1]);
  }
  if (node == nullptr || written.substr(6) == node->v.text.text) return std::nullopt;
  return std::string(node->v.text.text);
}

#else

bool CanReadHtml() { return false; }

void ReadHtmlMarkup(std::string_view /*html*/, MarkupSink& /*sink*/) {
  throw LackError(
      "HTML cannot be read: the program was built without libgumbo; install "
      "libgumbo-dev and build it again");
}

std::optional<std::string> NamedCharacters(std::string_view /*name*/) { return std::nullopt; }

#endif

}  // namespace moontrace
