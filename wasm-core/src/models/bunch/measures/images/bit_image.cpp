#include "models/bunch/measures/images/bit_image.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace panicle {
namespace {

constexpr std::int32_t word_bits = 64;
constexpr std::uint64_t all = ~std::uint64_t{0};

// A word whose bits from `bit` on are 1.
std::uint64_t from_bit(std::int32_t bit) { return all << bit; }
// A word whose bits below `bit` are 1.
std::uint64_t up_to_bit(std::int32_t bit) { return bit == word_bits ? all : ~(all << bit); }

// Spreads a row's bits by one pixel to both sides.
void widen(std::vector<std::uint64_t>& row) {
  std::uint64_t before = 0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::uint64_t word = row[i];
    const std::uint64_t after = i + 1 < row.size() ? row[i + 1] : 0;
    row[i] = word | word << 1 | before >> 63 | word >> 1 | after << 63;
    before = word;
  }
}

}  // namespace

// Makes the image of that size, all pixels clear.
void BitImage::reset(std::int32_t columns, std::int32_t rows) {
  columns_ = std::max(columns, 0);
  rows_ = std::max(rows, 0);
  words_ = static_cast<std::size_t>((columns_ + word_bits - 1) / word_bits);
  bits_.assign(words_ * static_cast<std::size_t>(rows_), 0);
}

// Whether a pixel is set; false outside the image.
bool BitImage::at(std::int32_t column, std::int32_t row) const {
  if (column < 0 || column >= columns_ || row < 0 || row >= rows_) return false;
  return row_words(row)[column / word_bits] >> (column % word_bits) & 1;
}

// Sets the pixels from column `from` up to, not including, `to` of a row. Returns how many were clear before; `wanted`
// becomes the number of those pixels inside the image.
std::int32_t BitImage::fill(std::int32_t row, std::int32_t from, std::int32_t to, std::int32_t* wanted) {
  from = std::max(from, 0);
  to = std::min(to, columns_);
  const bool inside = row >= 0 && row < rows_ && from < to;
  if (wanted) *wanted = inside ? to - from : 0;
  if (!inside) return 0;
  std::uint64_t* const words = row_words(row);
  const std::int32_t last = (to - 1) / word_bits;
  std::int32_t clear = 0;
  for (std::int32_t i = from / word_bits; i <= last; ++i) {
    std::uint64_t mask = all;
    if (i == from / word_bits) mask &= from_bit(from % word_bits);
    if (i == last) mask &= up_to_bit(to - i * word_bits);
    clear += std::popcount(mask & ~words[i]);
    words[i] |= mask;
  }
  return clear;
}

// The number of set pixels.
std::int64_t BitImage::count() const {
  std::int64_t sum = 0;
  for (const std::uint64_t word : bits_) sum += std::popcount(word);
  return sum;
}

// The number of set pixels in a row.
std::int32_t BitImage::count_row(std::int32_t row) const {
  std::int32_t sum = 0;
  for (std::size_t i = 0; i < words_; ++i) sum += std::popcount(row_words(row)[i]);
  return sum;
}

// The number of pixels set in both images, which have the same size.
std::int64_t BitImage::count_common(const BitImage& other) const {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < bits_.size(); ++i) sum += std::popcount(bits_[i] & other.bits_[i]);
  return sum;
}

// Clears the bits beyond the last column, as all functions expect.
void BitImage::clear_margin() {
  const std::int32_t rest = columns_ % word_bits;
  if (rest == 0) return;
  for (std::int32_t row = 0; row < rows_; ++row) row_words(row)[words_ - 1] &= up_to_bit(rest);
}

// The image in which all pixels within `radius` of a set one are set.
// Widens each row from the disc's uppermost chord, the narrowest, to its widest: each is the one before, widened a
// little more.
BitImage BitImage::dilated(float radius) const {
  BitImage result(columns_, rows_);
  const auto reach = static_cast<std::int32_t>(std::max(radius, 0.0f));
  std::vector<std::uint64_t> wide(words_);
  for (std::int32_t row = 0; row < rows_; ++row) {
    const std::uint64_t* const source = row_words(row);
    if (std::all_of(source, source + words_, [](std::uint64_t word) { return word == 0; })) continue;
    wide.assign(source, source + words_);
    std::int32_t by = 0;
    for (std::int32_t away = reach; away >= 0; --away) {
      const auto y = static_cast<float>(away);
      const auto chord = static_cast<std::int32_t>(std::sqrt(std::max(0.0f, radius * radius - y * y)));
      for (; by < chord; ++by) widen(wide);
      for (const std::int32_t target : {row - away, row + away}) {
        if (target < 0 || target >= rows_) continue;
        std::uint64_t* const words = result.row_words(target);
        for (std::size_t i = 0; i < words_; ++i) words[i] |= wide[i];
      }
    }
  }
  result.clear_margin();
  return result;
}

// The image without holes and gaps narrower than a disc of that radius: dilated, then eroded (the dilation of the
// complement).
BitImage BitImage::closed(float radius) const { return dilated(radius).complement().dilated(radius).complement(); }

// The image with all pixels inverted.
BitImage BitImage::complement() const {
  BitImage result = *this;
  for (std::uint64_t& word : result.bits_) word = ~word;
  result.clear_margin();
  return result;
}

}  // namespace panicle
