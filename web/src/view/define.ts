import type { ShaderMaterial, Texture } from 'three';
import { isMeasure, type Shading } from './shading';

/**
 * Defines a name in the shaders of a material, or removes it. What is rarely shown is compiled when
 * it is first shown; until then the shaders are smaller and faster.
 */
export function define(material: ShaderMaterial, name: string, isDefined: boolean): void {
  if (isDefined === name in material.defines) return;
  const { [name]: _, ...rest } = material.defines;
  material.defines = isDefined ? { ...rest, [name]: '' } : rest;
  material.needsUpdate = true;
}

/** `picture`: what a shading needs that shows one. */
export function defineShading(
  material: ShaderMaterial,
  shading: Shading,
  picture: Texture | null,
): void {
  define(material, 'HEAT', isMeasure(shading));
  define(material, 'PICTURE', picture !== null);
  material.uniforms.picture.value = picture;
}
