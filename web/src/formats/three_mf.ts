/** 3MF (3D Manufacturing Format, core specification 1.3) for printers: one closed body, millimetres, +Z up. */
import { type Zippable, zipSync } from "fflate";
import type { Part } from "../plant/part";
import type { About } from "./about";
import { GENERATOR } from "./generator";
import { solidNotes, solidOf } from "./solid";
import { printed } from "./stl";
import { TextBuffer } from "./text_buffer";
import { ZIP_DATE } from "./zip_date";

/** Decimals of a millimetre: a micrometre. */
const DECIMALS = 3;
const QUOTE = 0x22;
/** Compression level: higher ones take longer than all other work and save three hundredths. */
const LEVEL = 3;

const TYPES = `<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>`;
const RELATIONS = `<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>`;

/**
 * Makes the plant one solid body, enlarged or reduced for printing, and writes it.
 * @param thickness the least thickness, millimetres
 * @param note receives a sentence for each way in which the body differs from the request
 * @throws EmptyPlantError where the plant has no mesh
 */
export async function threeMf(
	parts: Iterable<Part>,
	about: About,
	thickness: number,
	note: (text: string) => void = () => {},
): Promise<Uint8Array<ArrayBuffer>> {
	const solid = await solidOf(parts, thickness / 1000);
	solidNotes(solid, thickness / 1000).forEach(note);
	const out = new TextBuffer();
	out.text(`<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><metadata name="Title">${escaped(`${about.name}, 1:${solid.scale}`)}</metadata><metadata name="Application">${GENERATOR}</metadata><metadata name="Description">${escaped(about.link)}</metadata><resources><object id="1" type="model"><mesh><vertices>`);
	const corners = printed(solid);
	for (let i = 0; i < corners.length; i += 3) {
		out.word('<vertex x="');
		out.fixed(corners[i], DECIMALS, QUOTE);
		out.word(' y="');
		out.fixed(corners[i + 1], DECIMALS, QUOTE);
		out.word(' z="');
		out.fixed(corners[i + 2], DECIMALS, QUOTE);
		out.word("/>");
	}
	out.word("</vertices><triangles>");
	for (let i = 0; i < solid.indices.length; i += 3) {
		out.word('<triangle v1="');
		out.integer(solid.indices[i], QUOTE);
		out.word(' v2="');
		out.integer(solid.indices[i + 1], QUOTE);
		out.word(' v3="');
		out.integer(solid.indices[i + 2], QUOTE);
		out.word("/>");
	}
	out.word('</triangles></mesh></object></resources><build><item objectid="1"/></build></model>');
	const encoder = new TextEncoder();
	const files: Zippable = {
		"[Content_Types].xml": encoder.encode(TYPES),
		"_rels/.rels": encoder.encode(RELATIONS),
		"3D/3dmodel.model": out.bytes(),
	};
	return zipSync(files, { level: LEVEL, mtime: ZIP_DATE });
}

/** Escapes the characters that XML reserves. */
function escaped(text: string): string {
	return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");
}
