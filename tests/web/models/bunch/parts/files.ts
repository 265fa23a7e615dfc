/** The files of a bunch, as the studio and the command line write them. */

import { exportGlb, type GlbOptions } from "../../../../../web/src/formats/glb";
import { exportObj } from "../../../../../web/src/formats/obj";
import type { BunchPlant } from "../../../../../web/src/models/bunch/bunch_plant";
import { bunchParts } from "../../../../../web/src/models/bunch/parts/bunch_parts";
import { aboutBunch, encodeQuery, type Specimen } from "../../../bunch";

export async function bunchGlb(
	grown: BunchPlant,
	specimen: Specimen,
	{ link, ...options }: GlbOptions & { link?: string } = {},
): Promise<Uint8Array<ArrayBuffer>> {
	return exportGlb(bunchParts(grown, specimen), await aboutBunch(grown, specimen, link), options);
}

export function bunchObj(grown: BunchPlant, specimen: Specimen, name: string): ReturnType<typeof exportObj> {
	const about = { name: `Bunch ${specimen.preset}`, link: encodeQuery(specimen), extras: {} };
	return exportObj(bunchParts(grown, specimen), about, name);
}
