// The boundary: a plain C ABI, the same for every model. web/src/core/ holds the one loader that speaks it.
//
// Requests and responses are containers of named arrays (foundation/container.hpp has the layout). The caller
// copies a request in, calls panicle_grow, copies the response out and releases both. Pointers are offsets into the
// module's memory.
//
// A request holds `model`, `seed`, `outputs`, `parameters` and other blocks of its model (protocol/request.hpp, and the
// model's own folder).
//
// A response always holds
//   status                uint32 x 3: reason (foundation/result.hpp; 0 = grown), line, column
// The response of a failed growth also has, and nothing else,
//   message               text
// A plant has
//   notes                 text, one a line
//   fingerprint           uint32 x 2: low, high word; over segments and organs
//   mesh_fingerprint      the same over the meshes, where requested
//   counts                uint32 each;  counts.names: text, one a line
//   measures              float32 each, in the order of the model's table; NaN: does not apply; where requested
//   segments.parent       int32 each: index of an earlier segment, -1 at a root
//   segments.tag          uint32 each: which line of segments.tags (text)
//   segments.ends         float32 x 6 each: start, end; metres
//   segments.radii        float32 x 2 each: at the start, at the end; metres
// where there are organs
//   organs.tag            uint32 each: which line of organs.tags (text)
//   organs.segment        int32 each: its parent segment, -1 for none
//   organs.mesh           int32 each: which of `meshes`, -1 for none
//   organs.transforms     float32 x 8 each: position; rotation as a unit quaternion x y z w; scale
//   organs.sky            uint8 each: the same as of meshes, as a mean over the organ; where requested
// its meshes
//   meshes                text: their names, one a line; and for each
//   mesh.NAME.material    text: its kind
//   mesh.NAME.positions   float32 x 3 per vertex, metres;  .normals x 3;  .uvs x 2
//   mesh.NAME.indices     uint32 x 3 per triangle, counter-clockwise
//   mesh.NAME.runs        uint32 x 4 each: first vertex, vertices, first index, indices;  .runs.names: text
//   mesh.NAME.sky         uint8 per vertex: how much of the sky it sees, 255 all, 0 none (light/sky.hpp); of a
//                         sheet the better of its sides; where requested, for meshes that are not shared by organs
//   mesh.NAME....         additional data of its vertices or runs
// and the model's own columns by name, described in the model's folder (models/<model>/model.hpp).
// where a limit or the end of the time cut the plant short
//   cut_short             uint32: 1 by a limit of the core (foundation/limits.hpp), 2 by the time limit of the host
#ifndef PANICLE_H
#define PANICLE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Version of this boundary. */
uint32_t panicle_abi(void);
/* Memory for a request; 0 when `bytes` is over the limit or memory is short. */
void* panicle_allocate(uint32_t bytes);
/* Frees a request's memory or a response. */
void panicle_release(void* memory);
/* Grows a plant. Returns a response, to be released, whose fourth word is its length in bytes; null only when memory is
 * out. Large arrays may lie outside of it: the directory has their places, counted from the response's first byte and
 * modulo 2^32. They are valid until the response is released or another plant is grown. */
uint8_t* panicle_grow(const uint8_t* request, uint32_t bytes);

/* Compiles a grammar (UTF-8) and stores it: the response has `status` and, where that is 0, `program` (uint32), the
 * handle that a request may name in place of its `grammar`. Compiling is most of the cost of a text, and a drag sends
 * the same text a hundred times. */
uint8_t* panicle_compile(const char* text, uint32_t bytes);
/* Frees a compiled grammar. */
void panicle_forget(uint32_t program);

#ifdef __cplusplus
}
#endif

#endif
