/**
 * Trees of ez-tree (npm), for comparison: from a preset's parameters to the buffers of branches and leaves. Its module makes
 * textures as it is read, for which there has to be a document; none of them is drawn.
 */
import { microseconds } from "./statistics.mjs";

const image = () => ({ addEventListener() {}, removeEventListener() {}, style: {} });

/** Name, vertices and microseconds of each preset. */
export async function peerTrees(runs) {
	globalThis.document ??= { createElementNS: image };
	const { Tree, TreePreset } = await import("@dgreenheck/ez-tree");
	return Object.keys(TreePreset).map((name) => {
		const tree = new Tree();
		tree.loadPreset(name);
		const time = microseconds(3, runs, (rounds) => {
			for (let i = 0; i < rounds; i++) tree.generate();
		});
		const count = [tree.branchesMesh, tree.leavesMesh].reduce(
			(sum, { geometry }) => sum + geometry.attributes.position.count,
			0,
		);
		return { name, count, time };
	});
}
