// A plug-in of clang-tidy: its checks walk through our own declarations only. Findings in the
// headers of others are thrown away in any case, but walking through them takes two thirds of the
// time. (LLVM does the same itself from version 21 on.)
#include <clang-tidy/ClangTidyCheck.h>
#include <clang-tidy/ClangTidyModule.h>
#include <clang-tidy/ClangTidyModuleRegistry.h>

namespace {

using clang::ast_matchers::MatchFinder;

class ScopeCheck : public clang::tidy::ClangTidyCheck {
 public:
  using ClangTidyCheck::ClangTidyCheck;

  void registerMatchers(MatchFinder* finder) override {
    finder->addMatcher(clang::ast_matchers::translationUnitDecl().bind("unit"), this);
  }

  // The unit is met before its children, which are then those of this scope.
  void check(const MatchFinder::MatchResult& result) override {
    std::vector<clang::Decl*> ours;
    for (clang::Decl* child : result.Context->getTranslationUnitDecl()->decls()) {
      if (!result.SourceManager->isInSystemHeader(child->getLocation())) ours.push_back(child);
    }
    result.Context->setTraversalScope(ours);
  }
};

class ScopeModule : public clang::tidy::ClangTidyModule {
 public:
  void addCheckFactories(clang::tidy::ClangTidyCheckFactories& factories) override {
    factories.registerCheck<ScopeCheck>("moontrace-scope");
  }
};

const clang::tidy::ClangTidyModuleRegistry::Add<ScopeModule> kScope(
    "moontrace-scope", "walks through our own declarations only");

}  // namespace
