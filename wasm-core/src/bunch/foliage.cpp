#include "bunch/foliage.hpp"

namespace panicle::bunch {

Foliage grow_foliage(const FoliageOptions&) { return {}; }

}  // namespace panicle::bunch
