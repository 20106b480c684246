// An L of 1 m thickness, its legs 4 m long, with a hole of 0.5 m across the lower one.
//   gmsh l_shape.geo -2 -format msh22 -setnumber size 0.5 -o l_shape.msh
SetFactory("OpenCASCADE");
DefineConstant[ size = 0.5 ];
Box(1) = {0, 0, 0, 1, 1, 4};
Box(2) = {0, 0, 0, 4, 1, 1};
Cylinder(3) = {2.5, -0.5, 0.5, 0, 2, 0, 0.25};
BooleanUnion(4) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
BooleanDifference(5) = { Volume{4}; Delete; }{ Volume{3}; Delete; };
Mesh.CharacteristicLengthMin = size;
Mesh.CharacteristicLengthMax = size;
Mesh.CharacteristicLengthFromCurvature = 0;
Mesh.CharacteristicLengthExtendFromBoundary = 0;
e = 1e-3;
clamp() = Surface In BoundingBox {-e, -e, 4 - e, 1 + e, 1 + e, 4 + e};
load() = Surface In BoundingBox {4 - e, -e, -e, 4 + e, 1 + e, 1 + e};
all() = Surface In BoundingBox {-e, -e, -e, 4 + e, 1 + e, 4 + e};
all() -= clamp();
all() -= load();
Physical Surface("clamp") = clamp();
Physical Surface("load") = load();
Physical Surface("free") = all();
Physical Volume("body") = Volume{:};
