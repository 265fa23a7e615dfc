/** Reading OBJ and MTL back with three.js's loaders. */
import type { Group } from "three";
import { MTLLoader } from "three/examples/jsm/loaders/MTLLoader.js";
import { OBJLoader } from "three/examples/jsm/loaders/OBJLoader.js";
import type { exportObj } from "../../../web/src/formats/obj";
import { readPng } from "./reading_png";

/** The same text with the colour of each picture of one pixel in `Kd`: three.js's loader makes pictures in a page alone. */
export function unpicturedMtl({ mtl, pictures }: Pick<ReturnType<typeof exportObj>, "mtl" | "pictures">): string {
	const blocks = mtl.split(/(?=^newmtl )/m).map((block) => {
		const named = /^map_Kd (.*)\n/m.exec(block)?.[1];
		const bytes = pictures.find(({ name }) => name === named)?.bytes;
		const { width, height, pixels } = bytes ? readPng(bytes) : { width: 0, height: 0, pixels: new Uint8Array(0) };
		const bare = block.replace(/^(map_Kd|norm) .*\n/gm, "");
		return width * height === 1 ? bare.replace(/^Kd .*/m, `Kd ${[...pixels].map((v) => v / 255).join(" ")}`) : bare;
	});
	return blocks.join("");
}

export function loadObj(files: ReturnType<typeof exportObj>): Group {
	return new OBJLoader().setMaterials(new MTLLoader().parse(unpicturedMtl(files), "")).parse(files.obj);
}
