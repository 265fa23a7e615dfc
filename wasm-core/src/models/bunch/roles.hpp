// What a symbol of the text draws: the roles that a bunch knows, declared and never read out of a name by chance.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lsystem/lsystem.hpp"
#include "models/bunch/skeleton.hpp"

namespace panicle::bunch {

class Roles {
 public:
  // `#role NAME SYMBOL` as a text declares it.
  struct Declaration {
    std::string_view role, symbol;
  };

  // Those of texts that declare none, as all did before there was a way to: parameters/bunch.json.
  Roles() = default;

  // What the text declares, if it declares anything. A role that a bunch does not have is told in `notes`.
  Roles(std::span<const Declaration> declared, std::vector<std::string>& notes);

  // Of what a production of `symbol` draws, or asks about; axis where no role claims it, as of the axiom ("").
  Kind of(std::string_view symbol) const;

 private:
  struct Claim {
    std::string symbol;
    Kind kind;
  };
  bool declared_ = false;
  std::vector<Claim> claims_;
};

// Those of a text.
Roles roles_of(const lsystem::Program& text, std::vector<std::string>& notes);

}  // namespace panicle::bunch
