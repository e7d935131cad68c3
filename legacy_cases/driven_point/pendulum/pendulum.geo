<?xml version="1.0" standalone="no"?>
<!DOCTYPE DDA SYSTEM "geometry.dtd">
<Berkeley:DDA xmlns:Berkeley="http://www.tsoft.com/~bdoolin/dda">
<!-- geometry -->
<Berkeley:Geometry>
<Berkeley:Edgenodedist distance="0.01"/>
<Jointlist>
<Joint type="1"> -0.1332201267 -1.915816379 -0.20371711 0.1029530916 </Joint>
<Joint type="1"> 0.2665362041 -1.90185658 0.1960392208 0.1169128903 </Joint>
<Joint type="1"> -0.1435630299 -1.906171466 0.2761811174 -1.891513677 </Joint>
<Joint type="1"> -0.2133620233 0.09261018839 0.206382124 0.107267977 </Joint>
</Jointlist>
<Fixedpointlist>
<Point> 0 0 </Point>
</Fixedpointlist>
</Berkeley:Geometry>
</Berkeley:DDA>
