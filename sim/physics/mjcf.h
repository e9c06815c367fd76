#pragma once

#include <string>

namespace moontrace {

/// MJCF text, made self-contained before MuJoCo compiles it.
struct Mjcf {
  std::string xml;              ///< one document: includes expanded, proxy inserted
  bool proxy_inserted = false;  ///< the model had none of its own
};

/// Prepares a model. Includes are expanded; folders of meshes and textures are made absolute (from
/// `folder`, where the model lies), if the model reads any; a model without a body named
/// `moontrace_proxy` gets the bodies of `proxy_xml` at the end of its world, and its keyframes the
/// proxy's rest. So the text needs no other document: a record keeps it unchanged. Not covered:
/// files of other kinds (plug-ins, models attached by MuJoCo 3). Throws InputError of one line that
/// begins with `name`: broken XML, another format than MJCF, an include that is missing or
/// repeated, sizes for which MuJoCo would take all memory.
Mjcf PrepareMjcf(const std::string& xml, const std::string& folder, const std::string& name,
                 const std::string& proxy_xml);

}  // namespace moontrace
