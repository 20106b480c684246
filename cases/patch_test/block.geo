// A cube of 1 m whose corner at (1, 1, 1) is cut off by the plane x + 2 y + 2 z = 4, in triangles.
//
//     gmsh -2 block.geo -o block.msh
h = 0.6;
Point(1) = {0, 0, 0, h};
Point(2) = {1, 0, 0, h};
Point(3) = {1, 1, 0, h};
Point(4) = {0, 1, 0, h};
Point(5) = {0, 0, 1, h};
Point(6) = {1, 0, 1, h};
Point(7) = {0, 1, 1, h};
Point(8) = {1, 1, 0.5, h};
Point(9) = {1, 0.5, 1, h};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Line(5) = {1, 5};
Line(6) = {2, 6};
Line(7) = {3, 8};
Line(8) = {4, 7};
Line(9) = {5, 6};
Line(10) = {6, 9};
Line(11) = {9, 8};
Line(12) = {8, 7};
Line(13) = {7, 5};
Line(14) = {9, 7};
Curve Loop(1) = {5, -13, -8, 4};
Curve Loop(2) = {1, 6, -9, -5};
Curve Loop(3) = {-4, -3, -2, -1};
Curve Loop(4) = {2, 7, -11, -10, -6};
Curve Loop(5) = {3, 8, -12, -7};
Curve Loop(6) = {9, 10, 14, 13};
Curve Loop(7) = {11, 12, -14};
For side In {1:7}
  Plane Surface(side) = {side};
EndFor
Physical Surface("x0") = {1};
Physical Surface("y0") = {2};
Physical Surface("z0") = {3};
Physical Surface("x1") = {4};
Physical Surface("y1") = {5};
Physical Surface("z1") = {6};
Physical Surface("cut") = {7};
