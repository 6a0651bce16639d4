/** lit-html, loaded before, has noted its version in a global list; a guest leaves nothing behind. */
export {}

const { litHtmlVersions: noted } = globalThis as { litHtmlVersions?: string[] }
noted?.pop()
if (noted?.length === 0) Reflect.deleteProperty(globalThis, 'litHtmlVersions')
