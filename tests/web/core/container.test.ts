import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { type Block, Columns, copyContainer, writeContainer } from "../../../web/src/core/container";

const numbers = (make: (values: number[]) => Exclude<Block["data"], string>, value: fc.Arbitrary<number>) =>
	fc.array(value, { maxLength: 12 }).map(make);
const data: fc.Arbitrary<Block["data"]> = fc.oneof(
	fc.string({ unit: "grapheme" }),
	numbers((values) => Uint8Array.from(values), fc.nat(255)),
	numbers((values) => Int32Array.from(values), fc.integer()),
	numbers((values) => Uint32Array.from(values), fc.nat()),
	numbers((values) => Float32Array.from(values), fc.float()),
);

describe("a container", () => {
	it("gives back by name what was put in", () => {
		const blocks = fc.uniqueArray(fc.record({ name: fc.string({ unit: "grapheme", minLength: 1 }), data }), {
			selector: ({ name }) => name,
		});
		fc.assert(
			fc.property(blocks, (written) => {
				const columns = new Columns(writeContainer(written));
				expect(columns.names).toEqual(written.map(({ name }) => name));
				for (const { name, data } of written) {
					if (typeof data === "string") expect(columns.text(name)).toBe(data);
					else expect(columns.any(name)).toEqual(data);
				}
			}),
		);
	});

	it("knows how wide rows are, and of what", () => {
		const columns = new Columns(writeContainer([{ name: "ends", data: new Float32Array(12), width: 6 }]));
		expect(columns.width("ends")).toBe(6);
		expect(columns.floats("ends")).toHaveLength(12);
		expect(() => columns.ints("ends")).toThrow("“ends” is float32, not int32");
		expect(() => columns.floats("radii")).toThrow("no column “radii”");
	});

	it("is refused where it is none, of another layout, or not whole", () => {
		const written = writeContainer([{ name: "a", data: Float32Array.of(1, 2, 3) }]);
		expect(new Columns(written.slice()).names).toEqual(["a"]);
		for (const word of [0, 1]) {
			const other = written.slice();
			other[4 * word]++;
			expect(() => new Columns(other)).toThrow(RangeError);
		}
		expect(() => new Columns(written.slice(0, written.length - 4))).toThrow("No container.");
		const longer = new Uint8Array(written.length + 4);
		longer.set(written);
		expect(() => new Columns(longer)).toThrow("No container.");
		expect(() => new Columns(new Uint8Array(8))).toThrow("No container.");
	});

	it("is copied whole out of a memory, wherever in it its arrays lie", () => {
		const written = writeContainer([
			{ name: "a", data: Float32Array.of(1, 2, 3) },
			{ name: "b", data: "text" },
		]);
		const memory = new Uint8Array(4096);
		const at = 1024;
		memory.set(written, at);
		const far = [64, 3000 & ~3]; // before the container, and behind it
		for (const place of far) {
			memory.set(new Uint8Array(Float32Array.of(4, 5, 6).buffer), place);
			// The first entry's data begin at its sixth word.
			new Uint32Array(memory.buffer)[(at + 4 * (4 + 5)) / 4] = place - at;
			const columns = new Columns(copyContainer(memory.buffer, at));
			expect([...columns.floats("a")]).toEqual([4, 5, 6]);
			expect(columns.text("b")).toBe("text");
			expect(columns.bytes.byteLength).toBeGreaterThan(written.byteLength);
		}
		new Uint32Array(memory.buffer)[(at + 4 * (4 + 5)) / 4] = 8000;
		expect(() => copyContainer(memory.buffer, at)).toThrow(RangeError);
	});

	it("is refused where the bytes are none", () => {
		const whole = writeContainer([{ name: "a", data: "b" }]);
		for (const bytes of [new Uint8Array(0), new Uint8Array(64), whole.slice(0, -4)]) {
			expect(() => new Columns(bytes)).toThrow(RangeError);
		}
	});
});
