/** Returns the browser's local storage; where it is forbidden, a storage that is always empty. */
export function localStorageOr(): Pick<Storage, "getItem" | "setItem"> {
	try {
		return localStorage;
	} catch {
		return { getItem: () => null, setItem: () => {} };
	}
}
