#include "plant/plant.hpp"

namespace panicle {

// Adds a column of text.
void Columns::add(std::string_view name, std::string_view text) {
  add(name, std::vector<char>(text.begin(), text.end()));
}

// Adds a column whose data another object, `owner`, keeps alive.
void Columns::keep(const ColumnView& view, std::shared_ptr<const void> owner) {
  all_.push_back({std::string(view.name), view.element, view.width, view.rows, view.data, std::move(owner)});
}

}  // namespace panicle
