/**
 * USDZ (Universal Scene Description, zipped), which phones show in augmented reality: meshes, UsdPreviewSurface and
 * PNGs, metres, +Y up. The layer is text, as the specification allows.
 */
import { type Zippable, zipSync } from "fflate";
import { meanColour } from "../plant/colour";
import type { Material } from "../plant/material";
import type { Part, PartMesh } from "../plant/part";
import type { Wooden } from "../plant/wood/wooden";
import type { About } from "./about";
import { GENERATOR } from "./generator";
import { lightParts } from "./light";
import { rounded } from "./numbers";
import { paletted } from "./palette";
import { png } from "./png";
import { TextBuffer } from "./text_buffer";
import { ZIP_DATE } from "./zip_date";

/** The most triangles, which phones draw easily. */
const TRIANGLES = 50_000;
const PIXELS = 512;
/** Decimals of a metre (a hundredth of a millimetre), of a normal, and of texture coordinates. */
const POSITION_DECIMALS = 5;
const NORMAL_DECIMALS = 3;
const UV_DECIMALS = 5;
const COMMA = 0x2c;
const CLOSE = 0x29;

/**
 * Writes parts as a USDZ file: simplified to TRIANGLES triangles, with pictures of PIXELS pixels, so that phones open
 * it.
 */
export async function usdz(parts: Iterable<Part>, about: About, plant?: Wooden): Promise<Uint8Array<ArrayBuffer>> {
	const light = paletted(await lightParts(parts, { triangles: TRIANGLES, pixels: PIXELS, plant }));
	const out = new TextBuffer();
	const pictures: [string, Uint8Array][] = [];
	out.text(`#usda 1.0
(
    customLayerData = {
        string creator = ${quoted(GENERATOR)}
        string link = ${quoted(about.link)}
    }
    defaultPrim = "Plant"
    metersPerUnit = 1
    upAxis = "Y"
)

def Xform "Plant" (
    assetInfo = {
        string name = ${quoted(about.name)}
    }
    kind = "component"
)
{
`);
	for (const [i, { shape }] of light.entries()) {
		if (!shape) continue;
		const { mesh, material } = shape;
		const picture = material.textures?.colour;
		if (picture) pictures.push([`textures/colour_${i}.png`, png(picture)]);
		writeMaterial(out, i, material, mesh, picture && `textures/colour_${i}.png`);
		writeMesh(out, i, mesh, material, picture && mesh.uvs);
	}
	out.text("}\n");
	return zipped([["plant.usda", out.bytes()], ...pictures]);
}

/**
 * Writes a mesh, bound to the material of the same index.
 * @param uvs texture coordinates, v from the picture's upper edge; undefined without a picture
 */
function writeMesh(
	out: TextBuffer,
	index: number,
	mesh: PartMesh,
	{ doubleSided }: Material,
	uvs?: Float32Array,
): void {
	const { low, high } = extentOf(mesh.positions);
	out.text(`    def Mesh "Part_${index}" (
        prepend apiSchemas = ["MaterialBindingAPI"]
    )
    {
        uniform bool doubleSided = ${doubleSided ? 1 : 0}
        float3[] extent = [(${low}), (${high})]
        rel material:binding = </Plant/Material_${index}>
        uniform token subdivisionScheme = "none"
        int[] faceVertexCounts = [${new Array(mesh.indices.length / 3).fill(3).join(",")}]
        int[] faceVertexIndices = [${mesh.indices.join(",")}]
        point3f[] points = `);
	vectors(out, mesh.positions, 3, POSITION_DECIMALS);
	out.text("\n        normal3f[] normals = ");
	vectors(out, mesh.normals, 3, NORMAL_DECIMALS);
	out.text(` (
            interpolation = "vertex"
        )
`);
	if (uvs) {
		out.text("        texCoord2f[] primvars:st = ");
		// USD measures v from a picture's lower edge.
		vectors(
			out,
			uvs.map((value, i) => (i % 2 === 1 ? 1 - value : value)),
			2,
			UV_DECIMALS,
		);
		out.text(` (
            interpolation = "vertex"
        )
`);
	}
	out.text("    }\n");
}

/**
 * Writes a UsdPreviewSurface.
 * @param mesh the mesh that uses it: its mean vertex colour multiplies the picture, because the preview surface ignores
 * vertex colours
 * @param picture path of the colour picture within the archive
 */
function writeMaterial(out: TextBuffer, index: number, material: Material, mesh: PartMesh, picture?: string): void {
	const path = `/Plant/Material_${index}`;
	const colour = picture ? `.connect = <${path}/Colour.outputs:rgb>` : ` = (${material.colour.map(short).join(", ")})`;
	// The mean shade of the vertices darkens the picture.
	const shade = material.textures?.colour && mesh.colours ? meanColour(mesh.colours) : [1, 1, 1];
	const { clearcoat, ior = 1.5, roughness } = material;
	out.text(`    def Material "Material_${index}"
    {
        token outputs:surface.connect = <${path}/Surface.outputs:surface>

        def Shader "Surface"
        {
            uniform token info:id = "UsdPreviewSurface"
            color3f inputs:diffuseColor${colour}
            float inputs:roughness = ${short(roughness)}
            float inputs:metallic = 0
            float inputs:ior = ${short(ior)}
            float inputs:clearcoat = ${short(clearcoat?.factor ?? 0)}
            float inputs:clearcoatRoughness = ${short(clearcoat?.roughness ?? 0)}
${picture && material.cutout ? `            float inputs:opacity.connect = <${path}/Colour.outputs:a>\n            float inputs:opacityThreshold = 0.5\n` : ""}            token outputs:surface
        }
`);
	if (picture) {
		const wrap = material.textures?.repeats ? "repeat" : "clamp";
		out.text(`
        def Shader "Coordinates"
        {
            uniform token info:id = "UsdPrimvarReader_float2"
            string inputs:varname = "st"
            float2 outputs:result
        }

        def Shader "Colour"
        {
            uniform token info:id = "UsdUVTexture"
            asset inputs:file = @${picture}@
            float4 inputs:scale = (${shade.map(short).join(", ")}, 1)
            token inputs:sourceColorSpace = "sRGB"
            float2 inputs:st.connect = <${path}/Coordinates.outputs:result>
            token inputs:wrapS = "${wrap}"
            token inputs:wrapT = "${wrap}"
            float3 outputs:rgb
${material.cutout ? "            float outputs:a\n" : ""}        }
`);
	}
	out.text("    }\n");
}

/** Writes vectors of `width` numbers as `[(x,y,z),…]`. */
function vectors(out: TextBuffer, values: Float32Array, width: number, decimals: number): void {
	out.word("[");
	for (let i = 0; i < values.length; i++) {
		if (i % width === 0) out.word(i > 0 ? ",(" : "(");
		out.fixed(values[i], decimals, i % width === width - 1 ? CLOSE : COMMA);
	}
	out.word("]");
}

/** Returns the corners of the bounding box as text. */
function extentOf(positions: Float32Array): { low: string; high: string } {
	const corner = (pick: (...values: number[]) => number) => {
		const best = [positions[0], positions[1], positions[2]];
		for (let i = 3; i < positions.length; i++) best[i % 3] = pick(best[i % 3], positions[i]);
		return best.map((value) => rounded(value, POSITION_DECIMALS)).join(", ");
	};
	return { low: corner(Math.min), high: corner(Math.max) };
}

/**
 * Makes the archive: files follow each other uncompressed, each from a multiple of 64 bytes on, so that readers can map
 * them.
 */
function zipped(files: readonly [string, Uint8Array][]): Uint8Array<ArrayBuffer> {
	const all: Zippable = {};
	let offset = 0;
	for (const [name, bytes] of files) {
		// A header of 30 bytes, the name, and an extra field of 4 bytes and padding.
		const start = offset + 30 + name.length + 4;
		const padding = (64 - (start % 64)) % 64;
		all[name] = [bytes, { extra: { 6534: new Uint8Array(padding) } }];
		offset = start + padding + bytes.length;
	}
	return zipSync(all, { level: 0, mtime: ZIP_DATE });
}

/** Rounds a number for the file. */
const short = (value: number) => rounded(value, 5);
/** Returns a text in quotes, on one line. */
const quoted = (text: string) => JSON.stringify(text.replace(/[\r\n]+/g, " "));
