#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include "grammar_files.hpp"
#include "sanitizers.hpp"

namespace panicle::tests {

std::string repository_folder() { return PANICLE_REPOSITORY; }
bool has_sanitizers() { return PANICLE_HAS_SANITIZERS; }

}  // namespace panicle::tests
