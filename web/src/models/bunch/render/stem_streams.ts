/** Vertex streams of the stems for the view: as grown, or bare, with withered pedicels marked. */
import { linear } from "../../../plant/colour";
import type { Stream } from "../../../render/streams";
import { type BunchPlant, INTERNODE_STATES, type StemMesh } from "../bunch_plant";
import { stemColours } from "../parts/stem_colour";

const MARKED = linear("c2334f");
/** Share of their radius by which marked pedicels are enlarged, since they are short and thin. */
const SWELLING = 0.6;

/**
 * Returns the stems' vertex streams.
 * @param hex the look's stem colour
 * @param bare without berries: all of the sky is visible, and withered pedicels are marked
 */
export function stemStreams(grown: BunchPlant, stem: StemMesh, hex: string, bare: boolean): Stream[] {
	const colours = stemColours(grown, stem, hex);
	const open = () => new Uint8Array(stem.internode.length).fill(255);
	return [
		["position", bare ? markWithered(grown, stem, colours) : stem.positions, 3],
		["normal", stem.normals, 3],
		["color", colours, 3],
		["sky", bare ? open() : (stem.sky ?? open()), 1],
		["internode", stem.internode, 1],
	];
}

/** Colours withered pedicels in `colours`, and returns the vertex positions, enlarged at these pedicels. */
function markWithered(
	{ internodes }: BunchPlant,
	{ positions, normals, internode }: StemMesh,
	colours: Float32Array,
): Float32Array {
	const withered = INTERNODE_STATES.indexOf("withered");
	const swollen = positions.slice();
	for (let vertex = 0; vertex < internode.length; vertex++) {
		const of = internode[vertex];
		if (internodes.state[of] !== withered) continue;
		colours.set(MARKED, 3 * vertex);
		const by = SWELLING * 0.5 * (internodes.radii[2 * of] + internodes.radii[2 * of + 1]);
		for (let k = 3 * vertex; k < 3 * vertex + 3; k++) swollen[k] += by * normals[k];
	}
	return swollen;
}
