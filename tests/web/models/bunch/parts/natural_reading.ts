/** Natural bunches as three.js reads them back. */

import { Color, type Mesh, type MeshPhysicalMaterial, Vector3 } from "three";
import type { GlbOptions } from "../../../../../web/src/formats/glb";
import type { BunchPlant } from "../../../../../web/src/models/bunch/bunch_plant";
import type { Look, Specimen } from "../../../bunch";
import { load, meshesOf } from "../../../formats/reading";
import { sampleSpecimen } from "../fixture";
import { bunchGlb } from "./files";

export const specimen = sampleSpecimen({ preset: "short-conical", seed: 7 });
export const looking = (look: Partial<Look>): Specimen => ({ ...specimen, look: { ...specimen.look, ...look } });

export async function read(from: BunchPlant, of: Specimen = specimen, options?: GlbOptions) {
	const { scene } = await load(await bunchGlb(from, of, { translucent: true, ...options }));
	scene.updateMatrixWorld(true);
	const meshes = meshesOf(scene);
	const named = (start: string) => meshes.filter(({ userData }) => userData.name?.startsWith(start));
	return { named, skin: named("Berry ")[0]?.material as MeshPhysicalMaterial };
}

/** Returns a vertex's position in the scene. */
export const placeOf = (mesh: Mesh, vertex: number) =>
	new Vector3().fromBufferAttribute(mesh.geometry.attributes.position, vertex).applyMatrix4(mesh.matrixWorld);

/** Returns a vertex's colour in a viewer, in linear light. */
export function shade(mesh: Mesh, vertex: number): Color {
	const { color } = mesh.geometry.attributes;
	const tint = new Color(color.getX(vertex), color.getY(vertex), color.getZ(vertex));
	return tint.multiply((mesh.material as MeshPhysicalMaterial).color);
}

export const brightness = ({ r, g, b }: Color) => 0.2126 * r + 0.7152 * g + 0.0722 * b;

/** Those vertices of a mesh whose v is within `reach` of `v`. */
export function around(mesh: Mesh, v: number, reach: number): number[] {
	const { uv } = mesh.geometry.attributes;
	return Array.from({ length: uv.count }, (_, i) => i).filter((i) => Math.abs(uv.getY(i) - v) <= reach);
}
