/** The texts of a room: typed look-up of its messages (messages.json), in the language in use. */
import type { Value } from "./format";
import { translated } from "./locale";

/** English messages by key: texts, or functions of named arguments. */
type Messages = Readonly<Record<string, string | ((args: never) => string)>>;

type ArgumentsOf<M> = M extends (args: infer A) => string ? [args: A] : [];
/** The same arguments, each of which may be anything that Lit can draw. */
type PieceArgumentsOf<M> = M extends (args: infer A) => string ? [args: { [K in keyof A]: unknown }] : [];

/** A message with its code, for errors and notes that programs read. */
export interface Message {
	/** The room and the key: "app.copy_link". */
	readonly code: string;
	/** Arguments by name. */
	readonly args: Readonly<Record<string, Value>>;
	/** The sentence, in the language in use. */
	readonly text: string;
}

/** Looks up the messages of one room. */
export interface Texts<C extends Messages> {
	/** The text of a message: `text("copied", { count })`. Call it when the text is needed, not when a module loads. */
	<K extends keyof C & string>(key: K, ...args: ArgumentsOf<C[K]>): string;
	/** A message with arguments that are drawn, such as links and keys, as a list that Lit draws. */
	pieces<K extends keyof C & string>(key: K, ...args: PieceArgumentsOf<C[K]>): unknown[];
	/** A message with its code, for an error or a note. */
	message<K extends keyof C & string>(key: K, ...args: ArgumentsOf<C[K]>): Message;
}

/** Private characters that stand for drawn arguments while a message is put together. */
const FIRST_MARK = 0xe000;
const MARKS = /([\ue000-\ue0ff])/;

/**
 * Makes the look-up of a room.
 * @param room the room's name in codes: "app", "models.flower"
 * @param english the English messages
 */
export function textsOf<C extends Messages>(room: string, english: C): Texts<C> {
	const look = (key: string, args?: Record<string, Value>): string => {
		const entry = english[key];
		const text = typeof entry === "function" ? entry((args ?? {}) as never) : entry;
		return translated(`${room}.${key}`, text, args);
	};
	/**
	 * Looks up a message whose arguments include drawn ones: each is replaced by a private character, by which the
	 * translated text is split afterwards.
	 */
	const pieces = (key: string, args: Record<string, unknown> = {}): unknown[] => {
		const drawn: unknown[] = [];
		const marked = Object.entries(args).map(([name, value]) => {
			if (typeof value === "string" || typeof value === "number") return [name, value];
			drawn.push(value);
			return [name, String.fromCharCode(FIRST_MARK + drawn.length - 1)];
		});
		return look(key, Object.fromEntries(marked))
			.split(MARKS)
			.map((part) => (MARKS.test(part) ? drawn[part.charCodeAt(0) - FIRST_MARK] : part));
	};
	const message = (key: string, args: Record<string, Value> = {}): Message => ({
		code: `${room}.${key}`,
		args,
		text: look(key, args),
	});
	return Object.assign(look, { pieces, message }) as unknown as Texts<C>;
}
