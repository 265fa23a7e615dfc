/** Packs files for Godot: the engine reads a project from one .pck file (format version 2, core/io/file_access_pack.cpp). */

const MAGIC = 0x43504447;
const HEADER = 24 + 8 + 64;

/**
 * Returns the bytes of a .pck file.
 * @param {ReadonlyMap<string, Uint8Array>} files by their paths in the project, without `res://`
 */
export function packed(files) {
	const names = [...files.keys()].map((path) => {
		const bytes = Buffer.from(`res://${path}`);
		return Buffer.concat([bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4)]);
	});
	const base = HEADER + 4 + names.reduce((sum, name) => sum + 4 + name.length + 8 + 8 + 16 + 4, 0);
	const head = Buffer.alloc(base);
	let at = 0;
	const number = (value) => {
		at = head.writeUInt32LE(value, at);
	};
	const long = (value) => {
		at = head.writeBigUInt64LE(BigInt(value), at);
	};
	// The magic number, the version of the format, and the version of the engine.
	for (const value of [MAGIC, 2, 4, 0, 0, 0]) number(value);
	long(base);
	at = HEADER;
	number(files.size);
	let offset = 0;
	for (const [index, content] of [...files.values()].entries()) {
		number(names[index].length);
		at += names[index].copy(head, at);
		long(offset);
		long(content.length);
		// The engine does not check the MD5 sum, and the last number has the flags: neither encrypted nor removed.
		at += 16;
		number(0);
		offset += content.length;
	}
	return Buffer.concat([head, ...files.values()]);
}
