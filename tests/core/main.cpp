#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include "grammar_files.hpp"

namespace panicle::tests {

std::string repository_folder() { return PANICLE_REPOSITORY; }

}  // namespace panicle::tests
