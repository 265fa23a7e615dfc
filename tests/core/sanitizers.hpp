// Whether a test program is linked with the sanitizers, which keep memory of their own.
#pragma once

namespace panicle::tests {

bool has_sanitizers();

}  // namespace panicle::tests
