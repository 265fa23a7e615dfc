import fc from "fast-check";
import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { isEdited } from "../../../../web/src/models/flower/design/choose";
import { usual } from "../../../../web/src/models/flower/design/description";
import { assembled, designOf } from "../../../../web/src/models/flower/design/design";
import { readFlowerPlant } from "../../../../web/src/models/flower/flower_plant";
import { model } from "../../../../web/src/models/flower/index";
import { fetchedText, fetchTexts } from "../../../../web/src/models/flower/texts";
import { grammarOfXml } from "../../../../web/src/models/flower/xml/designed";
import { textOfXml } from "../../../../web/src/models/flower/xml/read";
import { xmlOf } from "../../../../web/src/models/flower/xml/write";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { TextError } from "../../../../web/src/specimen/text_error";
import { inRun } from "../../../long_run.mjs";
import { freshCore } from "../../core/wasm";

let core: Core;
beforeAll(async () => {
	await fetchTexts();
	core = await freshCore("flower.wasm");
});

/** Table 4, in full. */
const TABLE_4 = `<volume category="#define"> <name>STEM</name><degree>8</degree> <transl_coef>0</transl_coef><x_rotation>0</x_rotation>
<y_rotation>0</y_rotation><z_rotation>0</z_rotation> <height>1</height><length>1</length><width>2</width> <material>1</material> </volume>
<variable category="#define"> <thickness>7</thickness> </variable>
<axiom prefix="#axiome : ">STEM</axiom>
<rule> <predecessor init="p00 "> <volume category="predcsr"> <name>STEM</name><degree/> <transl_coef/><x_rotation/><y_rotation/><z_rotation/>
<height/><length/><width/><material/> </volume> <block1/> <condition/> <block2/> <element>-></element> </predecessor> <successor>
<volume category="root"> <name>STEM</name><degree/> <transl_coef/><x_rotation/><y_rotation/><z_rotation/> <height/><length/><width/><material/> </volume>
<element>[</element> <volume category="successor"> <name>STEM</name><degree/> <transl_coef/><x_rotation>0</x_rotation> <y_rotation>0</y_rotation>
<z_rotation>0</z_rotation> <height/><length/><width/><material/> </volume> <element>]_</element> <face>{E}</face> </successor> </rule>`;

const grown = (grammar: string) => {
	const { volumes, fingerprint, counts, segments } = readFlowerPlant(
		core.grow(model.encode({ ...fromPreset(model), grammar }, { meshes: false, map: false })),
	);
	const { values, order, parent, label, labels } = volumes;
	return {
		fingerprint,
		counts,
		values,
		order,
		parent,
		ends: segments.ends,
		names: Array.from(label, (of) => labels[of]),
	};
};

/** Presets to grow: together they use every feature of the language. */
const GROWN = new Set(["table-3", "figure-16", "petal", "tulip", "daisy"]);

const mistake = (xml: string): string => {
	try {
		textOfXml(xml);
	} catch (error) {
		expect(error).toBeInstanceOf(TextError);
		return (error as TextError).message;
	}
	return "";
};

describe("a flower's grammar as XML", () => {
	it("reads Table 4 as it is printed, which has no single root", () => {
		expect(textOfXml(TABLE_4).split("\n")).toEqual([
			"#define STEM(8,0,0,0,0,1,1,2,1)",
			"#define thickness=7",
			"#axiom: STEM",
			"p00 STEM -> STEM[STEM(,,0,0,0,,,,)]_{E}",
			"",
		]);
		expect(grown(textOfXml(TABLE_4)).counts.volumes).toBe(11);
	});

	it("converts every preset's text, and back to the same flower", () => {
		for (const { name } of model.presets.list) {
			const text = fetchedText(fromPreset(model, name)) ?? "";
			const back = textOfXml(xmlOf(text));
			if (GROWN.has(name)) expect(grown(back), name).toEqual(grown(text));
			expect(textOfXml(xmlOf(back)), name).toBe(back);
		}
	});

	it("writes the organs of a design, each before its section, wherever their lines are", () => {
		const text = assembled([usual("petal", { outline: "cordate", count: 7 })]);
		const back = designOf(textOfXml(xmlOf(text)));
		expect(back?.sections.map(({ description }) => description)).toEqual(
			designOf(text)?.sections.map(({ description }) => description),
		);
		const [amid, none] = ["A ->\n@organ stem@\nA[A]_{E}", "A -> @organ stem@ A[A]_{E}\n@organ thorn@"];
		expect(textOfXml(xmlOf(amid))).toBe("A -> A[A]_{E}\n@organ stem@\n");
		expect(textOfXml(xmlOf(none))).toBe("A -> A[A]_{E}\n");
	});

	it("recognises a design's own text, and edits made by hand in it", () => {
		const text = assembled([usual("petal", { outline: "cordate", count: 7 })]);
		expect(grammarOfXml(xmlOf(text))).toBe(text);
		const edited = text.replace("STIGMA -> STIGMA[LOBE]", "STIGMA -> STIGMA[LOBE(,20)]");
		expect(edited).not.toBe(text);
		const back = designOf(grammarOfXml(xmlOf(`p0 STEM -> STEM[COLLAR]_{C1}\n${edited}`)));
		expect(back?.sections.filter(isEdited).map(({ description }) => description.organ)).toEqual(["pistil"]);
		expect(back?.head).toBe("p0 STEM -> STEM[COLLAR]_{C1}\n");
		expect(grammarOfXml(TABLE_4)).toBe(textOfXml(TABLE_4));
	});

	it("spells out omitted numbers in the form of their definitions", () => {
		const text = `#define A(4,1,5,0,0,2,2,2,1)\n#define B(4,5,0,0,2,2,2,1)\n#define C\n#axiom: A\n#define finalStep=3
A{}{step < 1}{} -> A[B(, <10 & 3>, , ,
	3)]_{E}
A -> A[A(,2)]_{C1}[&M(,7){k = 2}]C2,C3
B{}{sin(90) > 0}{} -E-> B(,,1) C(, 4)
B : B_C1 < A_C2 -> B_C1 | A_C2
#module M\n#define k=1\n#define A(4,0,0,0,k,2,2,1)\n#axiom: A(,3)`.replace(" & 3", " + 3");
		expect(grown(textOfXml(xmlOf(text)))).toEqual(grown(text));
		expect(xmlOf(text)).toContain("<condition>step &lt; 1</condition>");
		expect(xmlOf(text)).toContain("<transl_coef>2</transl_coef>");
	});

	it("knows statements by their words, be there a blank or a comment behind the sign", () => {
		const text = `# define A(4,1,0,0,0,1,1,1,1)
# @ how many @ define k=2
#\taxiome: A
# material 1 stem "7f9a55" "9ab36c"
A -> A[A(,,5)]_{E}[&M(,,7){n=k}]_{C1}
# module M
# define n=1
# define A(5,1,0,0,0,2,2,2,1)
# define finalStep=n
#axiom: A
A -> A[A(,,<9>)]_{E}`;
		const plain = text.replace(/#(?:\s|@[^@]*@)*/g, "#");
		expect(xmlOf(text)).toBe(xmlOf(plain));
		expect(textOfXml(xmlOf(text))).toContain("A -> A[A(,,5,,,,,,)]_{E}[&M(,,7,,,,,,){n=k}]_{C1}");
		expect(grown(textOfXml(xmlOf(text)))).toEqual(grown(text));
	});

	it("reports errors with line and column, and resolves no external entities", () => {
		expect(mistake('<!DOCTYPE x [<!ENTITY e SYSTEM "file:///etc/passwd">]><axiom>&e;</axiom>')).toContain(
			"Line 1, column 1: Document types",
		);
		expect(mistake("<axiom>&e;</axiom>")).toContain("Line 1, column 8: &e;");
		expect(mistake("<axiom>A</axiom>\n<rule>\n  <predecessor></rule>")).toContain(
			"Line 3, column 16: Expected </predecessor>",
		);
		expect(mistake("<grammar>\n <flower/></grammar>")).toContain("Line 2, column 2: <flower> is not one of");
		expect(mistake("<volume><name>A</name><depth>1</depth></volume>")).toContain("column 23");
		expect(mistake("<axiom>A<name>B</name></axiom>")).toContain("column 9: <axiom> may contain only text");
		expect(mistake("<rule><predecessor/></rule>")).toContain("<successor>");
		expect(mistake("")).toContain("no grammar");
		expect(mistake("words")).toContain("outside the elements");
		expect(mistake("<a>".repeat(40))).toContain("32 deep");
		expect(mistake("<axiom")).toContain("attribute or >");
		expect(mistake("<axiom x='1>")).toContain("never closed");
	});

	it("reads a file of one long line, and still reports an error's place", () => {
		const axioms = "<axiom>A</axiom>".repeat(2 ** 14);
		expect(textOfXml(axioms)).toBe("#axiom: A\n".repeat(2 ** 14));
		expect(mistake("<axiom/>".repeat(2 ** 15))).toContain("Line 1, column 1: <axiom> is empty.");
		expect(mistake(`<grammar>${axioms}<b/></grammar>`)).toContain(`Line 1, column ${2 ** 18 + 10}: <b> is not one of`);
	});

	it("ends with a text or a mistake, whatever the file", () => {
		const bit = fc.constantFrom(
			"<",
			">",
			"</",
			"/>",
			"<!--",
			"-->",
			"<![CDATA[",
			"]]>",
			"<?",
			"?>",
			"&",
			";",
			"&lt;",
			"&#x41;",
			"volume",
			"rule",
			"name",
			"axiom",
			"predecessor",
			"successor",
			"element",
			"face",
			"=",
			'"',
			" ",
			"\n",
			"A",
			"degree",
		);
		fc.assert(
			fc.property(fc.array(bit, { maxLength: 60 }), fc.nat(), (bits, at) => {
				for (const xml of [
					bits.join(""),
					TABLE_4.slice(0, at % TABLE_4.length) + bits.join("") + TABLE_4.slice((at % TABLE_4.length) + bits.length),
				]) {
					try {
						expect(typeof textOfXml(xml)).toBe("string");
					} catch (error) {
						expect(error).toBeInstanceOf(TextError);
					}
				}
			}),
			{ numRuns: inRun(500, 2000), seed: 14 },
		);
	});

	it("writes any text without breaking", () => {
		const text = fetchedText(fromPreset(model, "table-3")) ?? "";
		fc.assert(
			fc.property(fc.nat(text.length), fc.nat(40), (from, length) => {
				textOfXml(xmlOf(`#define A(4)\n${text.slice(0, from)}${text.slice(from + length)}`));
			}),
			{ numRuns: 300, seed: 14 },
		);
	});
});
