// Functions that the module imports from its host, under the name `env` (tools/host.js declares them to the linker).
#pragma once

#ifdef __EMSCRIPTEN__
// Returns the share of the time limit that has passed: 0 where there is no limit, 1 or more when the time is over.
// Called about once a millisecond while a request grows (foundation/work_budget.hpp).
extern "C" double panicle_time_passed(void);
#else
// Natively no request has a time limit.
inline double panicle_time_passed() { return 0; }
#endif
