/** The README of a game tree's archive, in English as all names in files. */

/** Returns the text. @param name of the tree @param link restores the plant in the app */
export function readme(name: string, link: string): string {
	return `${name}: a tree for games, grown by Panicle
${link}

Files
  ${name}.glb                   levels of detail and a body for collisions; metres, +Y up
  ${name}_Impostor.png          colour and coverage of the impostor
  ${name}_Impostor_Surface.png  normal (red: right, green: up; 128 is 0) and depth (blue: 255 near, 0 far)
  ${name}.json                  triangles of the levels, box of the pivots, ball of the impostor, collision

Levels
  The first scene of the GLB shows ${name}_LOD0. The extension MSFT_lod names the other levels.
  The second scene has ${name}_LOD0 to ${name}_LOD3 and UCX_${name}_00 as separate nodes.
  Each level has at most two materials and two draw calls. All levels share one picture of leaves.
  ${name}_LOD3 is made of crossed pictures. With a shader for octahedral impostors, use the PNG files instead.

Wind
  COLOR_1 holds, per vertex: red, the phase of the branch; green, how far the branch bends (0 at the trunk);
  blue, the phase of the leaf; alpha, the visible share of the sky. With the option --wind-colours, these are in COLOR_0.
  TEXCOORD_1 holds x and y of the pivot, and TEXCOORD_2 holds z, as shares of the box in ${name}.json. The pivot of
  leaves is the place at which their twig begins, and that of wood is where its branch leaves the trunk.

Impostor
  8 x 8 frames on the upper half of an octahedron. Column i and row j, both from 0: u = 2i/7 - 1, v = 2j/7 - 1,
  x = (u + v)/2, z = (u - v)/2, y = 1 - |x| - |z|. The unit vector of (x, y, z) points to the camera.
  Each frame shows the ball given in ${name}.json.

Collision
  UCX_${name}_00 is a convex body around the trunk. Unreal Engine uses the name. The same body is in the extras
  of ${name}_LOD0 as a cone without its tip.
`;
}
