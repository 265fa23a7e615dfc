/**
 * Similar records of a document, backed by the arrays of their fields. They become objects for computations, or are
 * written as text without objects: a plant has tens of thousands of numbers, and making objects and then text took more
 * time than growing.
 */
import { shortFloat } from "./numbers";
import type { TextBuffer } from "./text_buffer";

/** The values of rows under one key. */
export interface RowField<Value> {
	/** @returns the value of row `index` */
	at(index: number): Value;
	/** Appends the value as JSON. */
	write(out: TextBuffer, index: number): void;
}

type Fields<Row> = { readonly [Key in keyof Row]: RowField<Row[Key]> };

export class CsvRows<Row> {
	/** @param row the values of rows: a record (`recordRows`), or a number or a list */
	constructor(
		readonly count: number,
		readonly row: RowField<Row>,
	) {}

	/** Returns the value of row `index`. */
	record(index: number): Row {
		return this.row.at(index);
	}

	/** Returns the values of all rows. */
	records(): Row[] {
		return Array.from({ length: this.count }, (_, index) => this.row.at(index));
	}

	/** Appends the text that `JSON.stringify` makes of the records. */
	write(out: TextBuffer): void {
		out.word("[");
		for (let index = 0; index < this.count; index++) {
			if (index > 0) out.word(",");
			this.row.write(out, index);
		}
		out.word("]");
	}
}

/** Returns rows of records: objects with a field under each key, in the order of `all`. */
export function recordRows<Row extends object>(count: number, all: Fields<Row>): CsvRows<Row> {
	return new CsvRows(count, records(all));
}

/** Returns a field whose value is an object of several fields, read or written as JSON. */
function records<Row extends object>(all: Fields<Row>): RowField<Row> {
	const entries = Object.entries<RowField<unknown>>(all);
	const openings = entries.map(([key], place) => `${place === 0 ? "{" : ","}${JSON.stringify(key)}:`);
	return {
		at(index) {
			const row: Record<string, unknown> = {};
			for (const [key, field] of entries) row[key] = field.at(index);
			return row as Row;
		},
		write(out, index) {
			for (const [place, [, field]] of entries.entries()) {
				out.word(openings[place]);
				field.write(out, index);
			}
			out.word("}");
		},
	};
}

/** Returns the field of lists of whole numbers, one of `all` per row. */
export function lists(all: readonly ArrayLike<number>[]): RowField<number[]> {
	return {
		at: (index) => Array.from(all[index]),
		write(out, index) {
			out.word("[");
			for (let i = 0; i < all[index].length; i++) {
				if (i > 0) out.word(",");
				out.short(all[index][i]);
			}
			out.word("]");
		},
	};
}

/** Returns the field with the values of another field at the indices of a list. */
export function gathered<Value>(field: RowField<Value>, places: ArrayLike<number>): RowField<Value> {
	return { at: (index) => field.at(places[index]), write: (out, index) => field.write(out, places[index]) };
}

/** Returns the field of whole numbers, one per row. */
export function integers(values: ArrayLike<number>): RowField<number> {
	return {
		at: (index) => values[index],
		write: (out, index) => out.short(values[index]),
	};
}

/** Returns the field of floats: every `stride`th, from the one at `offset` on. */
export function floats(values: Float32Array, stride = 1, offset = 0): RowField<number> {
	return {
		at: (index) => shortFloat(values[stride * index + offset]),
		write: (out, index) => out.short(values[stride * index + offset]),
	};
}

/** Returns the field of vectors of floats: `width` of every `stride` floats, from the one at `offset` on. */
export function vectors<Vector extends number[]>(
	values: Float32Array,
	stride: number,
	offset: number,
	width: Vector["length"],
): RowField<Vector> {
	return {
		at(index) {
			const from = stride * index + offset;
			return Array.from(values.subarray(from, from + width), shortFloat) as Vector;
		},
		write(out, index) {
			for (let i = 0; i < width; i++) {
				out.word(i === 0 ? "[" : ",");
				out.short(values[stride * index + offset + i]);
			}
			out.word("]");
		},
	};
}

/** Returns the field of words, by their indices in a list. */
export function words<Word extends string>(list: readonly Word[], places: ArrayLike<number>): RowField<Word> {
	const texts = list.map((word) => JSON.stringify(word));
	return {
		at: (index) => list[places[index]],
		write: (out, index) => out.word(texts[places[index]]),
	};
}
