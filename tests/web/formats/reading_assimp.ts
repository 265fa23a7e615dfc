/** Files opened by Assimp, which is none of ours: how many triangles there are, and their bounds, in the file's unit. */
import assimpjs from "assimpjs";
import { Box3, Matrix4, Vector3 } from "three";

interface Node {
	/** Row by row. */
	transformation: number[];
	meshes?: number[];
	children?: Node[];
}

interface Scene {
	rootnode: Node;
	meshes: { vertices: number[]; faces: number[][] }[];
}

/** @throws Error with Assimp's own word where it cannot read them; the first file is the one that is opened */
export async function byAssimp(files: Record<string, Uint8Array>): Promise<{ triangles: number; bounds: Box3 }> {
	const assimp = await assimpjs();
	const list = new assimp.FileList();
	for (const [name, bytes] of Object.entries(files)) list.AddFile(name, bytes);
	const result = assimp.ConvertFileList(list, "assjson");
	if (!result.IsSuccess()) throw new Error(result.GetErrorCode());
	const scene: Scene = JSON.parse(new TextDecoder().decode(result.GetFile(0).GetContent()));
	const found = { triangles: 0, bounds: new Box3() };
	add(scene, scene.rootnode, new Matrix4(), found);
	return found;
}

function add(
	{ meshes, ...scene }: Scene,
	node: Node,
	above: Matrix4,
	found: { triangles: number; bounds: Box3 },
): void {
	const turn = new Matrix4().fromArray(node.transformation).transpose().premultiply(above);
	for (const index of node.meshes ?? []) {
		const { vertices, faces } = meshes[index];
		found.triangles += faces.length;
		const point = new Vector3();
		for (let i = 0; i < vertices.length; i += 3) {
			found.bounds.expandByPoint(point.fromArray(vertices, i).applyMatrix4(turn));
		}
	}
	for (const child of node.children ?? []) add({ meshes, ...scene }, child, turn, found);
}
