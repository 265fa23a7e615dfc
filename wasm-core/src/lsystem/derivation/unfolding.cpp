// Depth-first derivation: a stack of successors to be processed, and the finished string.

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "foundation/random.hpp"
#include "lsystem/derivation/branch.hpp"
#include "lsystem/derivation/derivation.hpp"
#include "lsystem/derivation/machine.hpp"

namespace panicle::lsystem {
namespace {

// Depth-first derivation for grammars whose productions depend on a module alone.
class Unfolding {
 public:
  Unfolding(const BoundProgram& bound, std::uint64_t seed, const Limits& limits, const Space* space)
      : machine_(bound, seed, limits, space), program_(*bound.program), limits_(limits) {}

  // Derives the axiom until no production applies, depth first: a stack holds the successors on the way.
  Result<Derived> run() {
    const std::uint64_t root = hash_text("axiom");
    machine_.begin(root);
    if (!open(program_.axiom, {root, no_symbol << 16 | no_symbol}, no_symbol, 0)) return machine_.error();
    while (!successors_.empty()) {
      Successor& successor = successors_.back();
      if (successor.at < successor.end) {
        if (!next(successor)) return machine_.error();
      } else {
        pending_used_ = successor.begin;
        successors_.pop_back();
      }
    }
    derived_.modules_written = done_.modules;
    derived_.string = std::make_shared<const String>(std::move(done_));
    return std::move(derived_);
  }

 private:
  // A successor on the stack: words of `pending_`, processed up to `at`.
  struct Successor {
    std::uint64_t begin, at, end;
    std::uint32_t generation;
  };

  // Processes the next module of a successor: unfolds it if a production rewrites it, else writes it; skips the rest of
  // a branch behind %.
  bool next(Successor& successor) {
    const std::uint32_t* const module = pending_.data() + successor.at;
    const std::uint32_t header = *module;
    successor.at += words_of(header);
    if (cutting_) {
      if (!cutting_->reached(symbol_of(header))) return true;
      cutting_.reset();
    }
    if (symbol_of(header) == cut_symbol) {
      cutting_.emplace();
      return true;
    }
    if (const Production* const production = rewritable(header) ? machine_.choose(module) : nullptr) {
      const std::uint32_t generation = successor.generation + 1;
      if (generation > limits_.steps) return machine_.fail(Machine::too_many_steps(limits_));
      derived_.steps = std::max(derived_.steps, generation);
      const Origin origin = has_lineage(header) ? origin_of(module) : Origin{};
      return open(production->successor, origin, symbol_of(header), generation);
    }
    return !machine_.failed() && keep(module);
  }

  // Whether a module may be rewritten. Communication modules (?E) are not: their responses come during interpretation.
  bool rewritable(std::uint32_t header) const {
    return symbol_of(header) != query_symbol && program_.rules[symbol_of(header)].productions.size() > 0;
  }

  // Puts a successor on the stack.
  bool open(const Template& successor, const Origin& parent, std::uint32_t symbol, std::uint32_t generation) {
    const std::uint64_t begin = pending_used_, end = begin + successor.words;
    if (!machine_.make_room(pending_, end) || !machine_.write(successor, pending_.data() + begin, parent, symbol))
      return false;
    pending_used_ = end;
    successors_.push_back({begin, begin, end, generation});
    return true;
  }

  // Appends a module to the finished string.
  bool keep(const std::uint32_t* module) {
    const std::uint32_t words = words_of(*module);
    if (!machine_.make_room(done_.words, done_.used + words)) return false;
    copy_words(done_.words.data() + done_.used, module, words);
    done_.used += words;
    ++done_.modules;
    return true;
  }

  Machine machine_;
  const Program& program_;
  const Limits& limits_;
  Derived derived_;
  std::vector<Successor> successors_;
  Words pending_;
  std::uint64_t pending_used_ = 0;
  String done_;
  std::optional<BranchEnd> cutting_;  // the end of the branch that a % removes
};

}  // namespace

// Unfolds the axiom completely: depth first if the grammar allows, else step by step.
Result<Derived> unfold(const BoundProgram& bound, std::uint64_t seed, const Limits& limits,
                       const DerivationOptions& options) {
  const bool queries = options.environment != nullptr && bound.program->has_queries;
  if (queries || options.watcher != nullptr || bound.program->by_steps())
    return develop_to_rest(bound, seed, limits, options);
  return Unfolding(bound, seed, limits, options.space).run();
}

}  // namespace panicle::lsystem
