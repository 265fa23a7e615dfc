/**
 * Trees of ez-tree (npm), for comparison: from a preset's parameters to the buffers of branches and leaves. Its module makes
 * textures as it is read, for which there has to be a document; none of them is drawn.
 */
import { microseconds } from "./statistics.mjs";

const image = () => ({ addEventListener() {}, removeEventListener() {}, style: {} });

/** Each preset of it: its name, the branches, the leaves and the vertices of its tree, and `time(runs)`. */
export async function peerTrees() {
	globalThis.document ??= { createElementNS: image };
	const { Tree, TreePreset } = await import("@dgreenheck/ez-tree");
	return Object.keys(TreePreset).map((name) => {
		const tree = new Tree();
		tree.loadPreset(name);
		const branches = branchesOf(tree);
		const [bark, leafy] = [tree.branchesMesh, tree.leavesMesh].map(
			({ geometry }) => geometry.attributes.position.count,
		);
		const leaves = leafy / (tree.options.leaves.billboard === "double" ? 8 : 4);
		const grow = (rounds) => {
			for (let i = 0; i < rounds; i++) tree.generate();
		};
		return { name, branches, leaves, vertices: bark + leafy, time: (runs) => microseconds(3, runs, grow) };
	});
}

/** Without the trunk, as ours are counted. */
function branchesOf(tree) {
	const { generateBranch } = tree;
	let count = -1;
	tree.generateBranch = function (branch) {
		count++;
		return generateBranch.call(this, branch);
	};
	tree.generate();
	delete tree.generateBranch;
	return count;
}
