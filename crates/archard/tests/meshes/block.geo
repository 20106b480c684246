// A block of 40 x 30 x 20 mm, its top in quadrilaterals, all else in triangles. Files are made by ./make
SetFactory("OpenCASCADE");
Box(1) = {-20, -15, -20, 40, 30, 20};
Mesh.MeshSizeMin = 20;
Mesh.MeshSizeMax = 20;
Mesh.Algorithm = 6;
Transfinite Curve {:} = 3;
Transfinite Surface {6};
Recombine Surface {6};
Physical Surface("top") = {6};
Physical Surface("bottom side") = {5};
Physical Surface("sides") = {1, 2, 3, 4};
