import { DoubleSide, Mesh, MeshBasicMaterial, Shape, ShapeGeometry } from "three";

/** A flat arrow on the floor that starts at the origin and points along +x. */
export class FloorArrow extends Mesh<ShapeGeometry, MeshBasicMaterial> {
  constructor() {
    const shape = new Shape();
    shape.moveTo(0, -0.035);
    shape.lineTo(0.2, -0.035);
    shape.lineTo(0.2, -0.11);
    shape.lineTo(0.38, 0);
    shape.lineTo(0.2, 0.11);
    shape.lineTo(0.2, 0.035);
    shape.lineTo(0, 0.035);
    const material = new MeshBasicMaterial({
      transparent: true,
      opacity: 0.92,
      depthWrite: false,
      side: DoubleSide,
      forceSinglePass: true, // it is flat: two passes would renew its program every frame
      toneMapped: false,
    });
    super(new ShapeGeometry(shape), material);
    this.renderOrder = 5;
  }

  override dispose(): void {
    this.removeFromParent();
    this.geometry.dispose();
    this.material.dispose();
  }
}
