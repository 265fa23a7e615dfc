/** Results of checks that programs print: `CHECK {"title": …, "passed": …, "found": …}`. */

/**
 * @typedef {{ title: string, passed: boolean, found?: string }} Check
 */

/**
 * Returns the checks in a program's output.
 * @param {string} output
 * @returns {Check[]}
 */
export const checksIn = (output) => [...output.matchAll(/^CHECK (.*)$/gm)].map(([, found]) => JSON.parse(found));
