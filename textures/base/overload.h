#pragma once

namespace moontrace {

/// Lambdas as one function object, the visitor of a std::variant. With a lambda for each kind and
/// none for `auto`, a kind that is added and forgotten does not compile.
///
///     std::visit(Overload{[](const Line& line) {...}, [](const Arc& arc) {...}}, piece);
template <class... Functions>
struct Overload : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overload(Functions...) -> Overload<Functions...>;

}  // namespace moontrace
