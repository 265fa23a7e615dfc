// The grammar of a request as a compiled program.
#pragma once

#include <memory>
#include <string_view>

#include "foundation/limits.hpp"
#include "foundation/result.hpp"
#include "lsystem/lsystem.hpp"
#include "protocol/request.hpp"

namespace panicle {

// Defaults of a model for texts that do not set them.
struct ProgramOptions {
  lsystem::Notation notation = lsystem::Notation::huang;
  lsystem::Lineages lineages = lsystem::Lineages::always;
};

// For Model::compile_text. Errors: those of lsystem::compile.
Result<CompiledText> compile_program(std::string_view text, const ProgramOptions& options, const Limits& limits);

// The program whose handle the block `program` holds; null where the request has no such block.
std::shared_ptr<const lsystem::Program> program_by_handle(Request& request);

// That program, or the compiled text of the block `grammar`. Errors: those of lsystem::compile; bad_request where the
// request has neither block.
Result<std::shared_ptr<const lsystem::Program>> requested_program(Request& request, const ProgramOptions& options,
                                                                  const Limits& limits);

}  // namespace panicle
