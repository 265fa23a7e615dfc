/** A closed mesh out of a file that a person brings. */
import type { ClosedMesh } from "../../specimen/closed_mesh";
import { closedMesh } from "./closed";
import { readGlb } from "./glb";
import { readObj } from "./obj";
import { MeshFileError } from "./soup";

/** Bytes that are read at most. */
const LARGEST = 64 * 1024 * 1024;

/** @throws MeshFileError with the reason in plain words */
export async function readMeshFile(file: File): Promise<ClosedMesh> {
	if (file.size > LARGEST) throw new MeshFileError(`${file.name} is larger than 64 MB: simplify it first.`);
	const glb = /\.glb$/i.test(file.name);
	if (!glb && !/\.obj$/i.test(file.name))
		throw new MeshFileError(`${file.name} is neither an OBJ nor a GLB: save the mesh as one of them.`);
	return closedMesh(glb ? readGlb(await file.arrayBuffer()) : readObj(await file.text()));
}
