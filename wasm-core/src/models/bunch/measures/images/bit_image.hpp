// Black-and-white images, one bit a pixel, for comparing, closing and counting silhouettes.
#pragma once

#include <cstdint>
#include <vector>

namespace panicle {

class BitImage {
 public:
  BitImage() = default;
  BitImage(std::int32_t columns, std::int32_t rows) { reset(columns, rows); }

  // Clears the image and sets its size; the memory is reused.
  void reset(std::int32_t columns, std::int32_t rows);

  std::int32_t columns() const { return columns_; }
  std::int32_t rows() const { return rows_; }
  bool at(std::int32_t column, std::int32_t row) const;

  // Sets the columns from `from` up to but not `to` of a row, as far as they are in the picture. Returns the number of
  // columns that had been clear; `wanted`, if not null, gets the number of columns that are in the picture.
  std::int32_t fill(std::int32_t row, std::int32_t from, std::int32_t to, std::int32_t* wanted = nullptr);

  std::int64_t count() const;
  std::int32_t count_row(std::int32_t row) const;

  // Pixels set here and in `other`, which is of the same size.
  std::int64_t count_common(const BitImage& other) const;

  // Every pixel within `radius` pixels of a set one. Exact for the disc of pixel centres; cost: rows × radius × words
  // to a row.
  BitImage dilated(float radius) const;

  // Morphological closing by that disc: pixels that no disc of the size can reach from outside are filled. The image
  // needs a clear margin of `radius` + 1 pixels.
  BitImage closed(float radius) const;

 private:
  // The words of a row's bits.
  std::uint64_t* row_words(std::int32_t row) { return bits_.data() + static_cast<std::size_t>(row) * words_; }
  const std::uint64_t* row_words(std::int32_t row) const {
    return bits_.data() + static_cast<std::size_t>(row) * words_;
  }
  BitImage complement() const;
  void clear_margin();

  std::int32_t columns_ = 0, rows_ = 0;
  std::size_t words_ = 0;  // to a row
  std::vector<std::uint64_t> bits_;
};

}  // namespace panicle
