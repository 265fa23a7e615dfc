/* The boundary: a plain C ABI. web/src/core/ holds the one loader that speaks it.
 *
 * All numbers are little-endian. The caller copies a request in, calls panicle_grow, copies the sections out and
 * frees the result. Nothing is kept between calls. Pointers are offsets into the module's memory.
 *
 * Request (32-bit words):
 *   0  magic 0x4c434e50 ("PNCL")
 *   1  version of this layout: 2
 *   2  model: 1 bunch
 *   3  outputs: bit 0 meshes, bit 1 measures
 *   4  seed
 *   5  sides of a stem's tube (0: default)
 *   6  segments of the berry mesh (0: default)
 *   7  P, number of parameters
 *   8  m in place of the profile's (0: from the profile)
 *   9  N, number of values in place of the profile's n (0: from the profile)
 *  10  G, bytes of grammar text (0: the built-in L-system 3)
 *  11  T, number of berries thinned by hand
 *  12… P × float32: the parameters of wasm-core/parameters/bunch.json that are not `look`, in its order; NaN: default
 *   …  N × uint32, n1 … nN as the paper counts
 *   …  T × uint32, ids of berries
 *   …  G bytes of UTF-8, padded to a word with zeros
 *
 * Sections of a result: see PANICLE_SECTION_*. A failed growth has STATUS and MESSAGE only. */
#ifndef PANICLE_H
#define PANICLE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct PanicleResult PanicleResult;

enum {
  PANICLE_SECTION_STATUS = 0,            /* uint32 × 3: reason (foundation/result.hpp; 0 = grown), line, column */
  PANICLE_SECTION_MESSAGE = 1,           /* UTF-8: the error's message */
  PANICLE_SECTION_NOTES = 2,             /* UTF-8: notes, one a line */
  PANICLE_SECTION_PLAN = 3,              /* float32 w r, int32 n rd, × 4 sides; int32 m, n of m − 1 axes */
  PANICLE_SECTION_SECOND = 4,            /* the second bunch's plan, the same; empty without one */
  PANICLE_SECTION_COUNTS = 5,            /* uint32 × 6: end structures, internodes, pedicels, berries, withered, cut */
  PANICLE_SECTION_INTERNODES = 6,        /* int32 × 4 each: parent, kind, axis, state */
  PANICLE_SECTION_INTERNODE_ENDS = 7,    /* float32 × 6 each: start, end; metres */
  PANICLE_SECTION_INTERNODE_RADII = 8,   /* float32 × 2 each; metres */
  PANICLE_SECTION_BERRIES = 9,           /* float32 × 4 each: centre, radius; metres */
  PANICLE_SECTION_BERRY_DIRECTIONS = 10, /* float32 × 3 each */
  PANICLE_SECTION_BERRY_PARENTS = 11,    /* int32 each */
  PANICLE_SECTION_FINGERPRINTS = 12,     /* uint32 × 4: skeleton and organs (low, high), meshes (low, high) */
  PANICLE_SECTION_STEM_POSITIONS = 13,   /* float32 × 3 per vertex; metres */
  PANICLE_SECTION_STEM_NORMALS = 14,
  PANICLE_SECTION_STEM_UVS = 15,
  PANICLE_SECTION_STEM_INDICES = 16,    /* uint32 */
  PANICLE_SECTION_STEM_INTERNODES = 17, /* uint32 per vertex */
  PANICLE_SECTION_STEM_PARTS = 18,      /* int32 axis, uint32 first vertex, vertices, first index, indices; × parts */
  PANICLE_SECTION_BERRY_POSITIONS = 19, /* the shared berry, unit radius, tip scar towards +Y */
  PANICLE_SECTION_BERRY_NORMALS = 20,
  PANICLE_SECTION_BERRY_UVS = 21,
  PANICLE_SECTION_BERRY_INDICES = 22,
  PANICLE_SECTION_PROCEDURE = 23,         /* uint32 × 2: 0 paper 1 natural, fruit; float32 × 2: taper, blunt */
  PANICLE_SECTION_BERRY_IDS = 24,         /* uint32 each */
  PANICLE_SECTION_BERRY_TRAITS = 25,      /* float32 × 8 each: bunch::Traits */
  PANICLE_SECTION_THINNED = 26,           /* uint32 id, uint32 why (bunch::Why), float32 × 3 place; each */
  PANICLE_SECTION_MEASURES = 27,          /* float32 × measures of parameters/measures.json; NaN: does not apply */
  PANICLE_SECTION_SURFACE_POSITIONS = 28, /* the berries' own surfaces (models/bunch/fruit/berry_surfaces.hpp); empty for paper */
  PANICLE_SECTION_SURFACE_NORMALS = 29,
  PANICLE_SECTION_SURFACE_UVS = 30,      /* of the pattern that all surfaces share */
  PANICLE_SECTION_SURFACE_INDICES = 31,  /* likewise */
  PANICLE_SECTION_SURFACE_PRESSED = 32,  /* uint8 per vertex */
  PANICLE_SECTION_FLOWER_POSITIONS = 33, /* the shared open flower: unit berry radius, its face towards +Y */
  PANICLE_SECTION_FLOWER_NORMALS = 34,
  PANICLE_SECTION_FLOWER_UVS = 35,
  PANICLE_SECTION_FLOWER_INDICES = 36,
  PANICLE_SECTION_FOLIAGE_POSITIONS = 37, /* leaves and cane; metres */
  PANICLE_SECTION_FOLIAGE_NORMALS = 38,
  PANICLE_SECTION_FOLIAGE_UVS = 39,
  PANICLE_SECTION_FOLIAGE_INDICES = 40,
  PANICLE_SECTION_FOLIAGE_PARTS = 41, /* uint32 × 5 each: kind (bunch::FoliagePart), first vertex … indices */
  PANICLE_SECTION_COUNT = 42
};

/* Version of this layout. */
uint32_t panicle_abi(void);
/* Memory for a request; 0 when `bytes` is over the limit or memory is short. */
void* panicle_allocate(uint32_t bytes);
void panicle_release(void* memory);
/* Grows. Never null but when memory is out; free it with panicle_free. */
PanicleResult* panicle_grow(const uint8_t* request, uint32_t bytes);
const void* panicle_section(const PanicleResult* result, uint32_t section);
uint32_t panicle_section_bytes(const PanicleResult* result, uint32_t section);
void panicle_free(PanicleResult* result);

#ifdef __cplusplus
}
#endif

#endif
