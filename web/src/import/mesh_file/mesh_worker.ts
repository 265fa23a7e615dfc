/** The worker that reads a mesh's file: reading, welding and simplifying half a million triangles takes seconds. */
import { messageOf } from "../../locale/message_error";
import type { FromMeshReader } from "./messages";
import { readMeshFile } from "./read";

/** Used part of a worker's global scope, which the page's types do not describe. */
interface Scope {
	postMessage(message: FromMeshReader): void;
	onmessage: ((event: MessageEvent<File>) => void) | null;
}

const scope = globalThis as unknown as Scope;
scope.onmessage = async ({ data }) => {
	scope.postMessage(
		await readMeshFile(data).then(
			(mesh): FromMeshReader => ({ type: "read", mesh }),
			(error: unknown) => ({ type: "failed", message: messageOf(error) }),
		),
	);
};
