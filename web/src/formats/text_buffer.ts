import { FileTooLargeError } from "./file_error";
import { MAX_TEXT_BYTES } from "./limits";
import { decimalsOf, EXACT_POWERS, shortFloat } from "./numbers";

/**
 * Text written as bytes: formatting a number here takes some ten nanoseconds, a tenth of `toFixed` and joining, which
 * makes an OBJ of a million numbers fast.
 */

const ZERO = 0x30;
const MINUS = 0x2d;
const POINT = 0x2e;
const LAST_OF_ASCII = 0x7f;
/** A sign, a zero and a point, fourteen digits, the character after it. */
const LONGEST_NUMBER = 18;
const LARGEST_INTEGER = 0x7fffffff;
const POWERS = [1, 10, 100, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9];

/** Bytes of a chunk of text: a long text is never copied to grow. */
const CHUNK = 1 << 20;
/** The first chunk is smaller: many texts are short. */
const FIRST_CHUNK = 1 << 16;

/** Collects text. Throws FileTooLargeError where the text becomes larger than `most`. */
export class TextBuffer {
	/** Complete chunks. */
	readonly #chunks: Uint8Array<ArrayBuffer>[] = [];
	/** Bytes of the complete chunks. */
	#complete = 0;
	#bytes: Uint8Array<ArrayBuffer>;
	#length = 0;

	/**
	 * @param chunk bytes of each chunk
	 * @param most the most bytes of the text
	 */
	constructor(
		readonly chunk = CHUNK,
		readonly most = MAX_TEXT_BYTES,
	) {
		this.#bytes = new Uint8Array(Math.min(chunk, FIRST_CHUNK));
	}

	/** Appends any text, as UTF-8. */
	text(text: string): void {
		const encoded = new TextEncoder().encode(text);
		this.#reserve(encoded.length);
		this.#bytes.set(encoded, this.#length);
		this.#length += encoded.length;
	}

	/** Appends a short text; many times as fast where it is ASCII. */
	word(word: string): void {
		this.#reserve(word.length);
		const bytes = this.#bytes;
		const from = this.#length;
		for (let i = 0; i < word.length; i++) {
			const code = word.charCodeAt(i);
			if (code > LAST_OF_ASCII) {
				this.text(word);
				return;
			}
			bytes[from + i] = code;
		}
		this.#length += word.length;
	}

	/** Appends a whole number, 0 … 2³¹ − 1, and the character `end`. */
	integer(value: number, end: number): void {
		this.#reserve(LONGEST_NUMBER);
		this.#digits(value, 1);
		this.#bytes[this.#length++] = end;
	}

	/** Appends `value` rounded to `decimals` (0 … 9), without trailing zeros, and the character `end`. */
	fixed(value: number, decimals: number, end: number): void {
		const power = POWERS[decimals];
		const scaled = Math.round(Math.abs(value) * power);
		if (!(scaled <= LARGEST_INTEGER)) {
			this.text(String(Number(value.toFixed(decimals))) + String.fromCharCode(end));
			return;
		}
		this.#reserve(LONGEST_NUMBER);
		if (value < 0 && scaled > 0) this.#bytes[this.#length++] = MINUS;
		const whole = Math.trunc(scaled / power);
		this.#digits(whole, 1);
		this.#fraction(scaled - whole * power, decimals);
		this.#bytes[this.#length++] = end;
	}

	/** Appends a float32 as JSON, in the fewest digits that read back as the same value: those of `shortFloat`. */
	short(value: number): void {
		const places = decimalsOf(value);
		if (places === undefined) {
			this.word(JSON.stringify(shortFloat(value)));
			return;
		}
		this.#reserve(LONGEST_NUMBER);
		if (value < 0) this.#bytes[this.#length++] = MINUS;
		const power = EXACT_POWERS[places];
		const scaled = Math.round(Math.abs(value) * power);
		const whole = Math.trunc(scaled / power);
		this.#digits(whole, 1);
		this.#fraction(scaled - whole * power, places);
	}

	/** Returns the text in pieces, for files. Append nothing afterwards. */
	chunks(): Uint8Array<ArrayBuffer>[] {
		return [...this.#chunks, this.#bytes.subarray(0, this.#length)];
	}

	/** Returns the text in one piece. */
	bytes(): Uint8Array<ArrayBuffer> {
		const whole = new Uint8Array(this.#complete + this.#length);
		let written = 0;
		for (const chunk of this.chunks()) {
			whole.set(chunk, written);
			written += chunk.length;
		}
		return whole;
	}

	/** Returns the text as a string. */
	toString(): string {
		const decoder = new TextDecoder();
		const texts = this.chunks().map((chunk) => decoder.decode(chunk, { stream: true }));
		return texts.join("") + decoder.decode();
	}

	/**
	 * Writes a point and the digits of a fraction, without trailing zeros; nothing for 0.
	 * @param scaled the fraction times 10 to the power of `decimals`
	 */
	#fraction(scaled: number, decimals: number): void {
		if (scaled === 0) return;
		let fraction = scaled | 0; // the remainder of a number that is not a small integer takes many times as long
		let places = decimals;
		for (; fraction % 10 === 0; fraction /= 10) places--;
		this.#bytes[this.#length++] = POINT;
		this.#digits(fraction, places);
	}

	/** Writes a whole number in at least `least` digits, the last one first. */
	#digits(value: number, least: number): void {
		let count = least;
		while (count < POWERS.length && value >= POWERS[count]) count++;
		let rest = value | 0;
		const bytes = this.#bytes;
		const from = this.#length;
		for (let at = from + count - 1; at >= from; at--) {
			const tenth = (rest / 10) | 0;
			bytes[at] = ZERO + rest - 10 * tenth;
			rest = tenth;
		}
		this.#length = from + count;
	}

	/**
	 * Makes room for bytes, in a new chunk if necessary.
	 * @throws FileTooLargeError if the text becomes too large
	 */
	#reserve(bytes: number): void {
		if (this.#length + bytes <= this.#bytes.length) return;
		if (this.#complete + this.#length + bytes > this.most) throw new FileTooLargeError(undefined, this.most);
		if (this.#length > 0) this.#chunks.push(this.#bytes.subarray(0, this.#length));
		this.#complete += this.#length;
		this.#length = 0;
		this.#bytes = new Uint8Array(Math.max(this.chunk, bytes));
	}
}
