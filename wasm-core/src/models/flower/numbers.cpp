#include "models/flower/numbers.hpp"

#include "foundation/random.hpp"

namespace panicle::flower {
namespace {

constexpr VolumeValues default_values = {4, 1, 0, 0, 0, 1, 1, 1, 1};

// The index of a field in a volume's values.
constexpr std::size_t index_of(Field field) { return static_cast<std::size_t>(field); }

}  // namespace

// Lists the growths and productions by their numbers.
Numbers::Numbers(const Program& program, FlowerEvaluation& evaluation)
    : program_(program), evaluation_(evaluation), growths_(program.growths), productions_(program.productions.size()) {
  for (const Production& production : program.productions) {
    productions_[production.number] = &production;
    for (const GrowAction& growth : production.growths) growths_[growth.number] = &growth;
  }
}

// Makes an instance the evaluation's current one, if it is not so already.
bool Numbers::enter(const std::vector<Instance>& instances, std::uint32_t instance) {
  if (entered_ == instance) return true;
  entered_ = instance;
  const Instance& of = instances[instance];
  return evaluation_.enter(of.grammar, of.address, given_[instance]);
}

// Overwrites the values that a label's definition gives.
bool Numbers::of_label(const Record& record, VolumeValues& values) {
  return evaluation_.describe(program_.labels[record.label].description, record.address, values);
}

// Computes the values (order, angles, sizes, material) of a record's volume: by its label or the volume before, by the
// module's axiom, and by the arguments of its growth or split. `known` are the values of earlier records. Returns false
// with the error in the evaluation.
bool Numbers::work_out(const Record& record, const std::vector<Record>& records, const std::vector<Instance>& instances,
                       const std::vector<VolumeValues>& known, float order, VolumeValues& values) {
  values = default_values;
  values[index_of(Field::order)] = order;
  const VolumeValues& before = record.before == invalid ? values : known[record.before];
  const Rank rank = record.before == invalid ? Rank{} : records[record.before].rank;
  if (record.kind == Record::Kind::rest || record.kind == Record::Kind::part) {
    const Production& split = production(record.source);
    const bool rest = record.kind == Record::Kind::rest;
    const bool across = !generalized_map::is_side(split.face);
    values = before;
    if (across) values[index_of(Field::height)] *= 0.5f;
    // The new volume of a split is not turned; of a split at the base, the remaining one.
    const bool straight = across ? rest == (split.face == generalized_map::base_face) : !rest;
    if (straight)
      for (const Field turn : {Field::turn_x, Field::turn_y, Field::turn_z}) values[index_of(turn)] = 0;
    if (!across && !rest) {
      values[index_of(Field::order)] = order;
      values[index_of(Field::height)] = 0.5f * before[index_of(Field::width)];
      values[index_of(Field::length)] = before[index_of(Field::length)];
      values[index_of(Field::width)] = before[index_of(Field::height)];
    }
    if (!enter(instances, record.instance)) return false;
    evaluation_.set_volume(before, rank, record.step);
    evaluation_.set_face(record.side);
    return evaluation_.run(split.blocks, records[record.before].address) &&
           evaluation_.describe(rest ? split.rest_description : split.part_description, record.address, values);
  }
  const bool begins = record.before == invalid || record.instance != record.maker;
  if (begins) {
    given_.resize(record.instance);
    given_.emplace_back();
  }
  if (begins && record.before != invalid && !growth(record.source).settings.empty()) {
    // Random values of a call have the volume's address, so that each call draws its own.
    if (!enter_call(record, records, instances, before) ||
        !evaluation_.evaluate_settings(growth(record.source).settings, record.address, given_[record.instance]))
      return false;
  }
  if (record.inherits) {
    values = before;
  } else {
    if (!enter(instances, record.instance)) return false;
    evaluation_.set_volume(before, rank, 0);
    evaluation_.set_face(record.side);
    if (!of_label(record, values)) return false;
  }
  if (begins) {
    if (!enter(instances, record.instance)) return false;
    const Grammar& grammar = program_.grammars[instances[record.instance].grammar];
    if (!evaluation_.describe(grammar.axiom_arguments, record.address, values)) return false;
  }
  if (record.kind == Record::Kind::axiom) return true;
  const GrowAction& growth = this->growth(record.source);
  if (growth.arguments.given == 0) return enter(instances, record.maker);
  return enter_call(record, records, instances, before) &&
         evaluation_.describe(growth.arguments, record.address, values);
}

// Enters the instance that makes a volume, and runs the blocks of the production that grows it.
bool Numbers::enter_call(const Record& record, const std::vector<Record>& records,
                         const std::vector<Instance>& instances, const VolumeValues& before) {
  if (!enter(instances, record.maker)) return false;
  evaluation_.set_volume(before, records[record.before].rank, record.step);
  evaluation_.set_face(record.side);
  return evaluation_.run(growth(record.source).blocks, hash_combine(records[record.before].address, record.step));
}

}  // namespace panicle::flower
