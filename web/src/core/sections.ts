/** Reads the sections of a result. Everything is copied out: no view of the core's memory leaves this file. */
import type { CoreExports } from "./exports";

export class Sections {
	constructor(
		private readonly core: CoreExports,
		private readonly result: number,
	) {}

	floats(section: number): Float32Array<ArrayBuffer> {
		return new Float32Array(this.copy(section));
	}

	ints(section: number): Int32Array<ArrayBuffer> {
		return new Int32Array(this.copy(section));
	}

	words(section: number): Uint32Array<ArrayBuffer> {
		return new Uint32Array(this.copy(section));
	}

	bytes(section: number): Uint8Array<ArrayBuffer> {
		return new Uint8Array(this.copy(section));
	}

	text(section: number): string {
		return new TextDecoder().decode(this.copy(section));
	}

	isEmpty(section: number): boolean {
		return this.core.panicle_section_bytes(this.result, section) === 0;
	}

	private copy(section: number): ArrayBuffer {
		const start = this.core.panicle_section(this.result, section) >>> 0;
		const bytes = this.core.panicle_section_bytes(this.result, section) >>> 0;
		// Asked for anew every time: the buffer is another one after the memory has grown.
		const heap = this.core.memory.buffer as ArrayBuffer;
		if (start + bytes > heap.byteLength) throw new RangeError(`section ${section} lies outside the core's memory`);
		return heap.slice(start, start + bytes);
	}
}
