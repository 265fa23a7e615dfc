// Roles that a text declares, and how listeners look them up.
#include <algorithm>

#include "lsystem/grammars.hpp"

using namespace panicle;
using namespace panicle::tests;
using lsystem::Roles;

namespace {

class Roll : public Recorder {
 public:
  explicit Roll(const BoundProgram& bound) : roles_(lsystem::roles(lsystem::program_of(bound))) {}
  void line(std::int32_t id, const Turtle& before, const Turtle& after, const Lineage& lineage) override {
    Recorder::line(id, before, after, lineage);
    called.push_back(name_of(lineage.parent_symbol) + "<" + name_of(lineage.grandparent_symbol));
  }
  std::vector<std::string> called;

 private:
  std::string name_of(std::uint32_t symbol) const {
    const std::uint32_t role = roles_.of(symbol);
    return role == Roles::none ? "none" : roles_.names[role];
  }
  const Roles& roles_;
};

}  // namespace

TEST_CASE("a text gives roles of any name to its symbols") {
  const auto program = sound(lsystem::compile(
      "#role rachis Ar1 Ar2\n#role axis Af\n#role rachis Ar3\naxiom: Ar1\nAr1 --> Ar2 Af\nAr2 --> F\nAr3 --> X",
      Limits{}));
  const Roles& roles = lsystem::roles(*program);
  CHECK(roles.names == std::vector<std::string>{"rachis", "axis"});
  const auto symbols = lsystem::symbols(*program);
  const auto role_of = [&](std::string_view symbol) {
    return roles.of(static_cast<std::uint32_t>(std::find(symbols.begin(), symbols.end(), symbol) - symbols.begin()));
  };
  CHECK(role_of("Ar1") == 0);
  CHECK(role_of("Ar2") == 0);
  CHECK(role_of("Ar3") == 0);
  CHECK(role_of("Af") == 1);
  CHECK(role_of("X") == Roles::none);
  CHECK(role_of("F") == Roles::none);
  CHECK(roles.of(lsystem::no_symbol) == Roles::none);
  CHECK(lsystem::roles(*sound(lsystem::compile("axiom: A", Limits{}))).names.empty());
}

TEST_CASE("a listener looks roles up by the symbols of a lineage") {
  const BoundPointer bound = compiled(
      "#role stem A\n#role leaf L M\naxiom: F A(1)\nA(i) : i>0 --> F [ L ] B A(i-1)\nL --> F M\nM --> F\nB --> F", {},
      lsystem::Lineages::always);
  Roll roll(*bound);
  draw(*bound, derived(*bound, 9), roll);
  CHECK(roll.called == std::vector<std::string>{"none<none", "stem<none", "leaf<stem", "leaf<leaf", "none<stem"});
  CHECK(roll.lines[2].parent == "L");
}

TEST_CASE("without lineages no module has a role") {
  const BoundPointer bound = compiled("#role stem A\naxiom: A\nA --> F");
  Roll roll(*bound);
  draw(*bound, derived(*bound, 9), roll);
  CHECK(roll.called == std::vector<std::string>{"none<none"});
}

TEST_CASE("invalid roles are errors") {
  std::string message;
  CHECK(trouble("#role stem A B\naxiom: A", {}, {}, &message) == "undefined 1:14");
  CHECK(message == "Neither the axiom nor any production contains the symbol “B”; remove the symbol from the role.");
  CHECK(trouble("axiom: A\n#role stem A\n#role leaf A", {}, {}, &message) == "syntax 3:12");
  CHECK(message == "“A” already has the role “stem”; a symbol can have only one role.");
  CHECK(trouble("axiom: A\n#role stem A F", {}, {}, &message) == "syntax 2:14");
  CHECK(message == "“F” is a turtle command and cannot have a role; give the role to the symbol that produces it.");
  CHECK(trouble("axiom: A\n#role stem +") == "syntax 2:12");
  CHECK(trouble("axiom: A\n#role stem ?E") == "syntax 2:12");
  CHECK(trouble("axiom: A\n#role stem A(1)") == "syntax 2:13");
  CHECK(trouble("axiom: A\n#role stem", {}, {}, &message) == "syntax 2:11");
  CHECK(message == "The role “stem” has no symbols; write them after its name.");
  CHECK(trouble("axiom: A\n#role") == "syntax 2:6");
  CHECK(trouble("axiom: A\n#role stem A A") == "none");
}
