// Pixel-format blocks on 128-bit x86 vectors (SSE4.1), for the targets sse41, avx2 and avx512.

inline __m128i load16(const std::uint8_t* p) { return _mm_loadu_si128(reinterpret_cast<const __m128i*>(p)); }
inline void store16(std::uint8_t* p, __m128i v) { _mm_storeu_si128(reinterpret_cast<__m128i*>(p), v); }

// Smallest byte of each three that begin at every byte of p; only every third of them is a pixel.
inline __m128i smallest_of_next_3(const std::uint8_t* p) {
  return _mm_min_epu8(_mm_min_epu8(load16(p), load16(p + 1)), load16(p + 2));
}

// 16 pixels of 3 bytes; reads 2 bytes beyond them.
inline void triplet_minimum_16(const std::uint8_t* p, std::uint8_t* to) {
  const __m128i first = _mm_setr_epi8(0, 3, 6, 9, 12, 15, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1);
  const __m128i second = _mm_setr_epi8(-1, -1, -1, -1, -1, -1, 2, 5, 8, 11, 14, -1, -1, -1, -1, -1);
  const __m128i third = _mm_setr_epi8(-1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 1, 4, 7, 10, 13);
  const __m128i a = _mm_shuffle_epi8(smallest_of_next_3(p), first);
  const __m128i b = _mm_shuffle_epi8(smallest_of_next_3(p + 16), second);
  const __m128i c = _mm_shuffle_epi8(smallest_of_next_3(p + 32), third);
  store16(to, _mm_or_si128(_mm_or_si128(a, b), c));
}

// 16 pixels of 4 bytes, the fourth of which does not count.
inline void quad_minimum_block(const std::uint8_t* p, std::uint8_t* to) {
  const __m128i low = _mm_set1_epi32(255);
  __m128i part[4];
  for (int i = 0; i < 4; ++i) {
    const __m128i x = load16(p + 16 * i);
    const __m128i least = _mm_min_epu8(_mm_min_epu8(x, _mm_srli_epi32(x, 8)), _mm_srli_epi32(x, 16));
    part[i] = _mm_and_si128(least, low);
  }
  store16(to, _mm_packus_epi16(_mm_packus_epi32(part[0], part[1]), _mm_packus_epi32(part[2], part[3])));
}

// 16 values of 16 bits.
inline void grey16_block(const std::uint8_t* p, int shift, std::uint8_t* to) {
  const __m128i count = _mm_cvtsi32_si128(shift);
  const __m128i most = _mm_set1_epi16(255);
  const __m128i a = _mm_min_epu16(_mm_srl_epi16(load16(p), count), most);
  const __m128i b = _mm_min_epu16(_mm_srl_epi16(load16(p + 16), count), most);
  store16(to, _mm_packus_epi16(a, b));
}

// Sum of the bytes of those of 16 triplets whose dark value is at least `level`.
inline std::uint64_t masked_triplet_sum(const std::uint8_t* p, const std::uint8_t* dark, std::uint8_t level) {
  const __m128i value = load16(dark);
  const __m128i mask = _mm_cmpeq_epi8(_mm_max_epu8(value, _mm_set1_epi8(static_cast<char>(level))), value);
  const __m128i zero = _mm_setzero_si128();
  const __m128i first = _mm_setr_epi8(0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 5);
  const __m128i second = _mm_setr_epi8(5, 5, 6, 6, 6, 7, 7, 7, 8, 8, 8, 9, 9, 9, 10, 10);
  const __m128i third = _mm_setr_epi8(10, 11, 11, 11, 12, 12, 12, 13, 13, 13, 14, 14, 14, 15, 15, 15);
  __m128i total = _mm_sad_epu8(_mm_and_si128(load16(p), _mm_shuffle_epi8(mask, first)), zero);
  total = _mm_add_epi64(total, _mm_sad_epu8(_mm_and_si128(load16(p + 16), _mm_shuffle_epi8(mask, second)), zero));
  total = _mm_add_epi64(total, _mm_sad_epu8(_mm_and_si128(load16(p + 32), _mm_shuffle_epi8(mask, third)), zero));
  return static_cast<std::uint64_t>(_mm_cvtsi128_si32(total)) + static_cast<std::uint64_t>(_mm_extract_epi32(total, 2));
}
