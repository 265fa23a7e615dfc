import { afterEach, describe, expect, it, vi } from "vitest";
import { listOfTasks, runTask } from "../../wasm-core/tools/tasks.mjs";

describe("scripts with named tasks", () => {
	const tasks = (run: (words: string[]) => void) => ({
		small: { about: "a small task", run },
		large: { about: "a large task", words: "[WORD]", run },
	});

	afterEach(() => {
		process.exitCode = undefined;
		vi.restoreAllMocks();
	});

	it("pass the words after the name to the task", async () => {
		const run = vi.fn();
		await runTask("bench", tasks(run), ["large", "a", "--b"]);
		expect(run).toHaveBeenCalledExactlyOnceWith(["a", "--b"]);
	});

	it("run the standard task without a name, or list the tasks", async () => {
		const [run, standard] = [vi.fn(), vi.fn()];
		const log = vi.spyOn(console, "log").mockImplementation(() => {});
		await runTask("bench", tasks(run), ["--check"], { standard });
		expect(standard).toHaveBeenCalledTimes(1);
		await runTask("bench", tasks(run), []);
		await runTask("bench", tasks(run), ["--help"], { standard });
		const list = "npm run bench -- NAME\n  small         a small task\n  large [WORD]  a large task";
		expect(listOfTasks("bench", tasks(run))).toBe(list);
		expect(log.mock.calls).toEqual([[list], [list]]);
		expect([run.mock.calls.length, standard.mock.calls.length]).toEqual([0, 1]);
	});

	it("end with status 2 and the list where the name is unknown", async () => {
		const [run, error] = [vi.fn(), vi.spyOn(console, "error").mockImplementation(() => {})];
		await runTask("bench", tasks(run), ["toString"]);
		expect(process.exitCode).toBe(2);
		expect(error.mock.calls[0][0]).toContain("No task “toString”.\nnpm run bench -- NAME");
		expect(run).not.toHaveBeenCalled();
	});
});
