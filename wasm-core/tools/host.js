// Declares to Emscripten's linker what the module's host supplies (src/exports/host.hpp). None of it is in the module.
mergeInto(LibraryManager.library, { panicle_time_passed: () => {} });
