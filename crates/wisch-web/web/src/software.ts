// Detects rendering without a graphics card.

let known: boolean | null = null;

export function isSoftwareRendered(): boolean {
  return (known ??= detectSoftware());
}

function detectSoftware(): boolean {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) return true;
  const name = gl.getExtension("WEBGL_debug_renderer_info");
  const software = /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name ? String(gl.getParameter(name.UNMASKED_RENDERER_WEBGL)) : "");
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return software;
}
