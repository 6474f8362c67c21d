/*! This script holds the following works.

three 0.187.0

The MIT License

Copyright © 2010-2026 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

uplot 1.6.32

The MIT License (MIT)

Copyright (c) 2022 Leon Sorokin

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
var ax=Object.defineProperty;var lx=(n,e,t)=>e in n?ax(n,e,{enumerable:!0,configurable:!0,writable:!0,value:t}):n[e]=t;var cp=(n,e,t)=>lx(n,typeof e!="symbol"?e+"":e,t);function z(n,e={},...t){let i=document.createElement(n);for(let[s,r]of Object.entries(e))s.startsWith("on")?i.addEventListener(s.slice(2),r):s==="class"?i.className=r:s.includes("-")||!(s in i)?i.setAttribute(s,r):i[s]=r;return i.append(...t.flat(1/0).filter(s=>s!=null)),i}function dn(n,e){let t=z("i",{},n);return e===null?[t]:[t,z("sub",{},String(e))]}function hp(n){return z("data",{"data-key":n})}function up(n,e,t){n.value=String(e),n.title=String(e),n.textContent=t}var du=180/Math.PI;function mr(n){if(Number.isNaN(n))return"\u2013";if(!Number.isFinite(n))return String(n);let e=Math.abs(n);if(e<5e-13)return"0";if(e<.001||e>=1e6)return n.toExponential(2);let t=e<10?4:e<100?3:e<1e3?2:1;return n.toFixed(t)}function pt(n,e=4){return String(Number(n.toPrecision(e)))}function cx(n){for(let e of[1,2,3,4,6,12]){let t=n/Math.PI*e,i=Math.round(t);if(i===0||Math.abs(t-i)>1e-9)continue;let s=i<0?"-":"",r=Math.abs(i)===1?"":String(Math.abs(i));return`${s}${r}\u03C0${e===1?"":`/${e}`}`}return null}function fu(n){let e=n?"\xB0":"rad";return{inDegrees:n,angleUnit:e,factor:i=>i==="revolute"&&n?du:1,position:i=>i==="revolute"?e:"m",velocity:i=>i==="revolute"?`${e}/s`:"m/s",acceleration:i=>i==="revolute"?`${e}/s\xB2`:"m/s\xB2",force:i=>i==="revolute"?"N m":"N",angle:i=>n?`${pt(i*du)}\xB0`:`${pt(i)} rad`,length:i=>`${pt(i)} m`,number:i=>Math.abs(i)<1e-12?"0":pt(i),cell:i=>n?pt(i*du,6):cx(i)??pt(i,6)}}var Oe=(n,e)=>[n[0]+e[0],n[1]+e[1],n[2]+e[2]],Pt=(n,e)=>[n[0]-e[0],n[1]-e[1],n[2]-e[2]],be=(n,e)=>[e*n[0],e*n[1],e*n[2]],hi=(n,e)=>n[0]*e[0]+n[1]*e[1]+n[2]*e[2],Gt=n=>Math.hypot(n[0],n[1],n[2]),Qi=(n,e)=>Gt(Pt(n,e)),fn=(n,e)=>[n[1]*e[2]-n[2]*e[1],n[2]*e[0]-n[0]*e[2],n[0]*e[1]-n[1]*e[0]],On=n=>be(n,1/(Gt(n)||1));function gr(n,e,t){let[i,s]=[Math.sin(t),Math.cos(t)],r=be(e,hi(e,n)*(1-s));return Oe(Oe(be(n,s),be(fn(e,n),i)),r)}var zs={x:[1,0,0],y:[0,1,0],z:[0,0,1],o:[0,0,0]};function ks(n,e){return Oe(Oe(be(n.x,e[0]),be(n.y,e[1])),be(n.z,e[2]))}function _r(n,e){return Oe(n.o,ks(n,e))}function pu({x:n,y:e,z:t,o:i},s,r){let[o,a]=[Math.sin(r),Math.cos(r)];return{x:Oe(be(n,a),be(e,o)),y:Pt(be(e,a),be(n,o)),z:t,o:Oe(i,be(t,s))}}function mu({x:n,y:e,z:t,o:i},s,r){let[o,a]=[Math.sin(r),Math.cos(r)];return{x:n,y:Oe(be(e,a),be(t,o)),z:Pt(be(t,a),be(e,o)),o:Oe(i,be(n,s))}}function es(n,{xyz:e,rpy:t}){let[i,s,r]=t.map(Math.sin),[o,a,l]=t.map(Math.cos);return{x:ks(n,[l*a,r*a,-s]),y:ks(n,[l*s*i-r*o,r*s*i+l*o,a*i]),z:ks(n,[l*s*o+r*i,r*s*o-l*i,a*o]),o:_r(n,e)}}function Qr(n){let e=Math.atan2(-n[2][0],Math.hypot(n[0][0],n[1][0]));return Math.hypot(n[0][0],n[1][0])<1e-9?[0,e,Math.atan2(-n[0][1],n[1][1])]:[Math.atan2(n[2][1],n[2][2]),e,Math.atan2(n[1][0],n[0][0])]}function dp(n){if(n.length===1)return n[0];let{x:e,y:t,z:i,o:s}=n.reduce(es,zs),r=Qr([0,1,2].map(a=>[e[a],t[a],i[a]])),o=a=>a.map(l=>Math.abs(l)<1e-15?0:l);return{xyz:o(s),rpy:o(r)}}function xl(n,e){let t=(i,s)=>n[3*i]*e[s]+n[3*i+1]*e[3+s]+n[3*i+2]*e[6+s];return[0,1,2].flatMap(i=>[0,1,2].map(s=>t(i,s)))}var _u=n=>[n[0],n[3],n[6],n[1],n[4],n[7],n[2],n[5],n[8]],xr=(n,e)=>[0,3,6].map(t=>n[t]*e[0]+n[t+1]*e[1]+n[t+2]*e[2]),gu=n=>n===0?1:Math.sin(n)/n;function xu(n){let e=Gt(n),[t,i]=[gu(e),gu(e/2)**2/2],s=[[1,0,0],[0,1,0],[0,0,1]].map(r=>{let o=fn(n,r);return Oe(Oe(r,be(o,t)),be(fn(n,o),i))});return _u(s.flat())}function fp(n){let e=be([n[7]-n[5],n[2]-n[6],n[3]-n[1]],.5),t=Math.atan2(Gt(e),(n[0]+n[4]+n[8]-1)/2);return be(e,1/gu(t))}function hx(n){let e=n*n;return n<.01?1/12+e*(1/720+e/30240):(1-n/2/Math.tan(n/2))/e}function yu(n,e){let t=fn(n,e);return Oe(Oe(e,be(t,.5)),be(fn(n,t),hx(Gt(n))))}var eo=[0,1,2,3,4,5].map(n=>{let e="xyz"[n%3];return n<3?{name:`base.v${e}`,axis:e,velocity:"v",force:"f",type:"prismatic"}:{name:`base.w${e}`,axis:e,velocity:"\u03C9",force:"n",type:"revolute"}}),vl=["x","y","z","roll","pitch","yaw"].map((n,e)=>({name:n,type:e<3?"prismatic":"revolute"})),pp=n=>n.slice(0,9),ts=n=>n.slice(9,12);function mp([n,e,t,...i]){let s=es(zs,{xyz:[n,e,t],rpy:i});return[0,1,2].flatMap(r=>[s.x[r],s.y[r],s.z[r]]).concat(s.o)}function gp(n){let[e,t,i]=[0,1,2].map(s=>[n[s],n[3+s],n[6+s]]);return{x:e,y:t,z:i,o:ts(n)}}var yl=class{constructor(e){this.rotation=pp(e),this.start=[0,0,0,...ts(e)]}pose(e){return[...xl(this.rotation,xu(e.subarray(0,3))),...e.subarray(3,6)]}rate(e,t,i){return[...yu(e.subarray(0,3),i.slice(3,6)),...xr(t,i)]}recenter(e){this.rotation=pp(this.pose(e)),e.fill(0,0,3)}};function vu(n,e,t,i){let[s,r]=[e-n,n-t];return i*(n+(1-i)*(s*(1-i)+r*i))}function _p([n,e],[t,i],s,r){let o=fp(xl(_u(n),e)),a=(d,u,m)=>d.map((g,x)=>vu(g,s*u[x],s*m[x],r)),l=a(o,t.slice(3,6),yu(o,i.slice(3,6))),c=Oe(ts(e),be(ts(n),-1)),h=a(c,xr(n,t),xr(e,i));return[...xl(n,xu(l)),...Oe(ts(n),h)]}var ux="\u0307",Sl=n=>({min:()=>-n,max:()=>n}),to=({state:n,changed:e},t,i)=>({get:()=>n[t][i],set(s){n[t][i]=s,e()}}),Su=({units:n},e)=>({factor:()=>n().factor(e),unit:()=>n().position(e)}),Mu=n=>({state:n.state,changed:n.changed,units:()=>n.units});function xp(n,e,{signs:t,name:i,most:s}){let{state:r}=n,{type:o}=n.freedoms[e],a=Mu(n),l={...Sl(2*s.speed),...Su(a,o),...to(a,"qd",e),unit:()=>n.units.velocity(o),label:t.velocity,key:`qd-${e}`,about:`${i}, velocity${r.mode==="pose"?"":" at the start"}`};if(r.mode==="pose"){let h={...l,...Sl(4*s.speed),...to(a,"qdd",e),unit:()=>n.units.acceleration(o),label:t.acceleration,key:`qdd-${e}`,about:`${i}, acceleration`};return[l,h]}if(r.law!=="constant")return[l];let c={...Sl(s.force),...to(a,"torque",e),factor:()=>1,unit:()=>n.units.force(o),label:t.force,key:`tau-${e}`,about:`${i}, ${o==="revolute"?"torque":"force"}`};return[l,c]}function yp(n,e){let{state:t}=n,i=n.joints[e],[s,r]=n.ranges[e],o=Mu(n),a={min:()=>s,max:()=>r,...Su(o,i.type)},l={...a,...to(o,"q",e),label:t.mode==="motion"||t.mode==="reach"?"start":dn("q",null),key:`q-${e}`,about:`${i.name}, position${t.mode==="pose"?"":" at the start"}`};if(t.mode==="reach")return[l];if(t.mode==="motion"){let u={...a,...to(o,"end",e),label:"end",key:`end-${e}`,about:`${i.name}, position at the end`};return[l,u]}let c=Math.max(1,...n.table.rows.map(u=>u.mass))*9.81,h={velocity:dn("q\u0307",null),acceleration:dn("q\u0308",null),force:dn("\u03C4",null)},d=i.type==="revolute"?{speed:Math.PI,force:c*n.size}:{speed:n.size,force:c};return[l,...xp(n,n.ofBase+e,{signs:h,name:i.name,most:d})]}function vp(n){let{state:e,size:t}=n,i=Mu(n),s=vl.map(({name:c,type:h},d)=>({...Sl(h==="revolute"?Math.PI:Math.max(2*t,1)),...Su(i,h),...to(i,"pose",d),label:c,key:`pose-${d}`,about:`base, ${c}${e.mode==="free"?" at the start":""}`}));if(e.mode==="motion"||e.mode==="reach")return s;let{rows:r,floating:o}=n.table,a=9.81*r.reduce((c,{mass:h})=>c+h,o.mass),l=n.freedoms.slice(0,n.ofBase).map(({name:c,axis:h,velocity:d,force:u,type:m},g)=>{let x={velocity:dn(d,h),acceleration:dn(`${d}${ux}`,h),force:dn(u,h)},f=m==="revolute"?{speed:Math.PI,force:a*t}:{speed:Math.max(2*t,2),force:2*a};return xp(n,g,{signs:x,name:c,most:f})});return[...s,...l.map(([c])=>c),...l.flatMap(([,c])=>c??[])]}var yr=class extends Error{constructor(e){super(`not positive definite at index ${e}`),this.joint=e}};function Vs(n,e,t){let i=t.length,s=t.map(()=>new Array(i).fill(0)),r=t.map(o=>e[o]);for(let o=0;o<i;o++){for(let a=0;a<=o;a++){let l=n[t[o]][t[a]];for(let c=0;c<a;c++)l-=s[o][c]*s[a][c];if(o===a&&!(l>1e-14*Math.abs(n[t[o]][t[o]])))throw new yr(t[o]);s[o][a]=o===a?Math.sqrt(l):l/s[a][a]}for(let a=0;a<o;a++)r[o]-=s[o][a]*r[a];r[o]/=s[o][o]}for(let o=i-1;o>=0;o--){for(let a=o+1;a<i;a++)r[o]-=s[a][o]*r[a];r[o]/=s[o][o]}return r}var bu=eo.map((n,e)=>e),Sp={none:()=>(n,e,t)=>t.map(()=>0),constant:({torque:n})=>()=>n,gravity:({equations:n})=>(e,t)=>{let i=n.spring_vector(t);return n.gravity_vector(e,t).map((s,r)=>s+i[r])},steady:({equations:n,hasFriction:e})=>(t,i,s)=>{let r=n.inverse_dynamics(t,i,s,s.map(()=>0)),o=n.mass_matrix(i),a=Vs(o,r.map(c=>-c),bu),l=e?null:n.friction_vector(s);return r.map((c,h)=>h<bu.length?0:bu.reduce((d,u)=>d+o[h][u]*a[u],c-(l?.[h]??0)))}};function Mp({floating:n}){let e="none: free fall";return n?{none:e,steady:"of joints: they keep their velocities",constant:"constant, on the base too",gravity:"G + K, on the base too: the robot floats"}:{none:e,constant:"constant",gravity:"G + K: the arm floats"}}function Pi(n,e){return z("div",{class:"scroll",role:"region",tabIndex:0,"aria-label":n},e)}function bp(n){let{joints:e,freedoms:t,ofBase:i,table:s}=n,r=s.rows.some(E=>E.viscous||E.coulomb.some(Boolean)||E.stribeck),o=s.rows.some(E=>E.spring),a=[{key:"q",sign:"q",unit:"position",isAngle:!0},{key:"qd",sign:"q\u0307",unit:"velocity",isAngle:!0},{key:"qdd",sign:"q\u0308",unit:"acceleration",isAngle:!0},{key:"tau",sign:"\u03C4",unit:"force"},{key:"coriolis",sign:"V",unit:"force"},{key:"gravity",sign:"G",unit:"force"},...o?[{key:"spring",sign:"K",unit:"force"}]:[],...r?[{key:"friction",sign:"F",unit:"force"}]:[]],l=new Map,c=E=>{let L=hp(E);return l.set(E,L),z("td",{},L)},h=[...new Set(t.map(E=>E.type))],d=a.map(()=>z("th",{class:"unit",scope:"col"})),u=z("table",{class:"numbers wide"},z("caption",{},"State and forces"),z("thead",{},z("tr",{},z("th",{scope:"col"},"joint"),a.map(({sign:E})=>z("th",{scope:"col"},z("i",{},E)))),z("tr",{},z("th",{class:"unit",scope:"col"},""),d)),z("tbody",{},t.map((E,L)=>{let F=L-i,I=z("th",{scope:"row"},z("span",{class:"dot"}),F<0?["base ",dn(E.velocity,E.axis)]:E.name);I.style.setProperty("--color",F<0?`var(--axis-${E.axis})`:`var(--joint-${F%8})`);let O=a.map(({key:V})=>V!=="q"?c(`${V}-${L}`):F<0?z("td"):c(`q-${F}`));return z("tr",{},I,O)}))),g=h.length>1?"kg m\xB2, kg m, kg":h[0]==="revolute"?"kg m\xB2":"kg",x=z("table",{class:"numbers matrix"},z("caption",{},"Mass matrix ",z("i",{},"M"),`, ${g}`),z("tbody",{},t.map((E,L)=>z("tr",{},t.map((F,I)=>c(`mass-${L}-${I}`)))))),f=z("span",{},"Tip"),p=(E,L,F)=>z("table",{class:"numbers"},z("caption",{},E," in the world"),z("tbody",{},["x","y","z"].map((I,O)=>z("tr",{},z("th",{scope:"row"},z("i",{},I)),c(L(O)),z("td",{class:"unit"},"m"),z("th",{scope:"row"},["roll","pitch","yaw"][O]),c(F(O)),z("td",{class:"unit angle"}))))),M=p(f,E=>`tip-${E}-3`,E=>`rpy-${E}`),P=i>0?p("Base",E=>`base-${E}`,E=>`baserpy-${E}`):null,y=z("details",{},z("summary",{},"Transform of the tip, 4 \xD7 4"),Pi("Transform of the tip",z("table",{class:"numbers matrix"},z("tbody",{},[0,1,2,3].map(E=>z("tr",{},[0,1,2,3].map(L=>c(`T-${E}-${L}`)))))))),A=z("table",{class:"numbers"},z("caption",{},"Energies, J"),z("tbody",{},[["T","kinetic"],["U","potential"],["T + U","total"]].map(([E,L])=>z("tr",{},z("th",{scope:"row"},z("i",{},E)),c(L))))),b=()=>z("table",{class:"numbers"},z("caption",{},"Momentum in the world; ",z("i",{},"L")," about the centre of mass"),z("tbody",{},["x","y","z"].map((E,L)=>z("tr",{},z("th",{scope:"row"},dn("p",E)),c(`linear-${L}`),z("td",{class:"unit"},"kg m/s"),z("th",{scope:"row"},dn("L",E)),c(`angular-${L}`),z("td",{class:"unit"},"kg m\xB2/s"))))),_=(E,L,F=1)=>up(l.get(E),L,mr(L*F));function v(){let{units:E}=n,L=n.evaluated();s.tips.length>1&&(f.textContent=n.tip().name),a.forEach(({key:I,isAngle:O})=>{(I==="q"?e:t).forEach((k,K)=>_(`${I}-${K}`,L[I][K],O?E.factor(k.type):1))});let F=L.mass.map((I,O)=>Math.abs(I[O]));if(t.forEach((I,O)=>t.forEach((V,k)=>{_(`mass-${O}-${k}`,L.mass[O][k]);let K=Math.abs(L.mass[O][k])/Math.sqrt(F[O]*F[k]);l.get(`mass-${O}-${k}`).parentElement.style.setProperty("--share",Number.isFinite(K)?Math.min(K,1).toFixed(3):0)})),L.tip.forEach((I,O)=>I.forEach((V,k)=>_(`T-${O}-${k}`,V))),[0,1,2].forEach(I=>_(`tip-${I}-3`,L.tip[I][3])),Qr(L.tip).forEach((I,O)=>_(`rpy-${O}`,I,E.factor("revolute"))),L.base){ts(L.base).forEach((O,V)=>_(`base-${V}`,O));for(let O of["linear","angular"])L.momentum[O].forEach((V,k)=>_(`${O}-${k}`,V));let I=[0,3,6].map(O=>L.base.slice(O,O+3));Qr(I).forEach((O,V)=>_(`baserpy-${V}`,O,E.factor("revolute")))}_("kinetic",L.kinetic),_("potential",L.potential),_("total",L.kinetic+L.potential)}function D(){a.forEach(({unit:E},L)=>{d[L].textContent=h.map(F=>n.units[E](F)).join(", ")}),C.querySelectorAll(".angle").forEach(E=>E.textContent=n.units.angleUnit),v()}let C=z("div",{class:"blocks"},Pi("Mass matrix",x),P&&Pi("Pose of the base",P),Pi("Pose of the tip",M),Pi("Energies",A),i>0?Pi("Momentum",b()):null);return n.on("units",D),n.on("time tip",v),D(),z("section",{class:"panel","aria-label":"Numbers"},Pi("State and forces",u),C,y)}function no({label:n,key:e,min:t,max:i,get:s,set:r,factor:o,unit:a,about:l}){let c=z("input",{type:"range",step:"any","data-key":e,"aria-label":l}),h=z("input",{type:"number",step:"any","aria-label":`${l}, as a number`}),d=z("span",{class:"unit"}),u=z("p",{class:"refused",role:"alert"}),m=z("div",{class:"slider"},z("span",{class:"what"},n),c,h,d,u),g=()=>{let[f,p]=[s(),o()],[M,P]=[Math.min(t(),f),Math.max(i(),f)];Object.assign(c,{min:M*p,max:P*p}),c.value=f*p,c.setAttribute("aria-valuetext",`${pt(f*p)} ${a()}`),(document.activeElement!==h||u.textContent)&&(h.value=pt(f*p,5)),d.textContent=a()},x=f=>{let p=Number(f)/o(),M=f.trim()!==""&&Number.isFinite(p),P=M?r(p):"expected a number";u.textContent=P?`${M?`${f} is refused: `:""}${P}`:"",g()};return c.addEventListener("input",()=>x(c.value)),h.addEventListener("change",()=>x(h.value)),g(),{row:m,show:g}}function dx(n){let{state:e,size:t}=n;return vl.slice(0,e.hasRotation?6:3).map(({name:i,type:s},r)=>{let o=s==="revolute"?Math.PI:1.2*t;return no({label:i,key:`target-${r}`,about:`target, ${i}`,min:()=>-o,max:()=>o,get:()=>e.target[r],set(a){e.target[r]=a,n.seek()},factor:()=>n.units.factor(s),unit:()=>n.units.position(s)})})}function wp(n){let{state:e,joints:t}=n,i=dx(n),s=z("input",{type:"checkbox",checked:e.hasRotation,"data-key":"rotation"});s.addEventListener("change",()=>{e.hasRotation=s.checked,n.seek(),n.tell("mode")});let r=z("div",{class:"head"},z("span",{class:"name"},z("b",{},"target"),` of ${n.tip().name}`),z("label",{class:"check"},s,"with its rotation")),o=z("p",{class:"said","data-key":"reached",role:"status"}),a=z("table",{class:"numbers solutions"}),l=(g,x,f)=>z("button",{type:"button",class:"chip","data-key":x,onclick:f},g),c=(g,x)=>z("tr",{class:x===e.reached.chosen?"chosen":""},z("th",{scope:"row"},String(x+1)),z("td",{},l("start",`start-${x}`,()=>n.choose(x,!0)),l("end",`solution-${x}`,()=>n.choose(x))),g.map((f,p)=>z("td",{},z("data",{value:String(f),title:String(f)},mr(f*n.units.factor(t[p].type))))));function h(){let{found:g,missing:x}=e.reached;a.hidden=g.length===0;let f=["","of the motion",...t.map(({name:p,type:M})=>`${p}, ${n.units.position(M)}`)];a.replaceChildren(z("thead",{},z("tr",{},f.map(p=>z("th",{scope:"col"},p)))),z("tbody",{},g.map(c))),o.classList.toggle("refused",x!==null),o.textContent=x?d(x):`${g.length} ${g.length===1?"solution":"solutions"} found: the motion goes to that which is marked.`}function d({way:g,turn:x}){let{factor:f,angleUnit:p}=n.units,M=2*Math.asin(Math.min(1,x/2))*f("revolute"),P=e.hasRotation?` and ${pt(M,3)} ${p}`:"";return`No solution found: ${pt(g,3)} m${P} are missing at the nearest positions, to which the motion goes.`}function u(){i.forEach(g=>g.show()),h()}return u(),{group:z("div",{class:"joint base"},r,i.map(g=>g.row),o,Pi("Solutions",a)),show:u}}var fx={motion:"Motion",reach:"Reach",free:"Free motion",pose:"Pose"},px={motion:"From start to end, from rest to rest; inverse dynamics gives the torques.",reach:"From the start to where the tip is at the target, dragged in the picture or typed: inverse kinematics, then inverse dynamics.",free:"From the start under given torques; forward dynamics gives the motion.",pose:"One state; inverse dynamics gives the torques that it takes."},mx={motion:"The base is held where it is, and the joints go from start to end, from rest to rest; inverse dynamics gives the torques, and the force and the moment that hold the base.",reach:"The base is held where it is. From the start to where the tip is at the target, dragged in the picture or typed: inverse kinematics, then inverse dynamics.",free:"Base and joints move freely from the start; forward dynamics gives the motion.",pose:"One state; inverse dynamics gives the torques that it takes, and the force and the moment on the base."};function gx(n,{name:e,value:t,unit:i}){let s=i==="rad",[r,o]=s?[-Math.PI,Math.PI]:t<0?[3*t,0]:[0,3*t||1];return no({label:z("i",{},e),key:`field-${e}`,about:i?`field ${e}`:`field ${e}, without unit`,min:()=>r,max:()=>o,get:()=>n.fields[e],set:a=>n.setFields({[e]:a}),factor:()=>s?n.units.factor("revolute"):1,unit:()=>s?n.units.angleUnit:i})}function wu({about:n,key:e,options:t,get:i,set:s}){let r=Object.entries(t).map(([a,l])=>z("option",{value:a},l)),o=z("select",{"data-key":e,onchange:()=>s(o.value)},r);return o.value=i(),z("label",{class:"choice"},z("span",{},n),o)}function _x({rows:n},e){let{on:t}=n[e];return n.filter(s=>!s.isPlace&&s.on===t).length>1||(t??-1)!==e-1?`on ${t===null?"the base":n[t].name}`:null}function Ep(n){let{state:e,joints:t,first:i}=n,s=[],o=Object.entries(fx).filter(([L])=>L!=="reach"||t.length>0).map(([L,F])=>z("button",{type:"button",role:"tab","data-key":`mode-${L}`,onclick:()=>n.setMode(L)},F)),a=z("div",{class:"tabs",role:"tablist","aria-label":"Kind of motion"},o);a.addEventListener("keydown",({key:L})=>{let F={ArrowRight:1,ArrowLeft:-1}[L];if(!F)return;let I=o.findIndex(V=>V.getAttribute("aria-selected")==="true"),O=o[(I+F+o.length)%o.length];O.focus(),O.click()});let l=z("p",{class:"said"}),c=z("div",{class:"settings"}),h=z("div",{class:"joints"}),d=z("div",{role:"tabpanel"},l,c,h),u=z("input",{type:"number",min:"0.1",max:"60",step:"any","data-key":"duration"}),m=z("p",{class:"refused",role:"alert"});u.addEventListener("change",()=>{let L=Number(u.value);m.textContent=L>0?"":"expected a number above zero",L>0&&(e.duration=Math.min(L,60)),u.value=e.duration,n.changed()});let g={cycloidal:"cycloidal",quintic:"quintic polynomial",cubic:"cubic polynomial"},x={joints:"each joint by itself",line:"straight line of the tip"},f=Mp(n.table),p=n.table.floating?mx:px,M=n.table.rows.some(L=>L.viscous!==0||L.coulomb.some(F=>F!==0)||L.stribeck),P=null;function y(){o.forEach(F=>{let I=F.dataset.key===`mode-${e.mode}`;F.setAttribute("aria-selected",I),F.tabIndex=I?0:-1}),l.textContent=p[e.mode],u.value=e.duration;let L=[];if(e.mode!=="pose"&&L.push(z("label",{class:"choice"},z("span",{},"duration, s"),u),m),e.mode==="motion"||e.mode==="reach"){let F=I=>{e.profile=I,n.changed()};L.push(wu({about:"profile",key:"profile",options:g,get:()=>e.profile,set:F}))}if(e.mode==="reach"){let F=I=>{e.path=I,n.changed()};L.push(wu({about:"way",key:"path",options:x,get:()=>e.path,set:F}))}if(e.mode==="free"){let F=I=>{e.law=I,y(),n.changed()};if(L.push(wu({about:"torques",key:"law",options:f,get:()=>e.law,set:F})),M){let I=z("input",{type:"checkbox",checked:e.hasFriction,"data-key":"friction"});I.addEventListener("change",()=>{e.hasFriction=I.checked,n.changed()}),L.push(z("label",{class:"check"},I,"friction"))}}c.replaceChildren(...L),s.length=0,P=e.mode==="reach"?wp(n):null,h.replaceChildren(...P?[P.group]:[],...n.table.floating?[A()]:[],...t.flatMap((F,I)=>{let O=yp(n,I).map(no);s.push(...O);let V=n.table.rows.findIndex(ce=>ce.joint===I),k=z("button",{type:"button",class:"name",onclick:()=>n.select(V)});k.append(z("span",{class:"dot"}),z("b",{},String(I+1)),` ${F.name}`);let K=z("span",{class:"kind"},F.type),Y=z("span",{class:"kind limits"}),Z=z("div",{class:"head"},k,K,Y),te=z("div",{class:"joint","data-joint":I},Z,O.map(ce=>ce.row));te.addEventListener("focusin",()=>n.select(V));let le=_x(n.table,V);return le===null?te:[z("h3",{class:"branch"},le),te]})),_(),b()}function A(){let L=vp(n).map(no);s.push(...L);let F=z("span",{class:"name"},z("b",{},"base")),I=z("span",{class:"kind"},"velocities and forces in its own axes");return z("div",{class:"joint base"},z("div",{class:"head"},F,I),L.map(O=>O.row))}function b(){let{factor:L,position:F}=n.units;h.querySelectorAll(".limits").forEach((I,O)=>{let{limits:V,type:k}=t[O],K=V?.map(Y=>pt(Y*L(k),4));I.textContent=K?`${K[0]} to ${K[1]} ${F(k)}`:"no limits"})}function _(){h.querySelectorAll("[data-joint]").forEach((L,F)=>{let{selected:I}=e;L.classList.toggle("selected",n.table.rows[I]?.joint===F),L.style.setProperty("--color",`var(--joint-${F%8})`)})}let v=i.fields.map(L=>gx(n,L)),D=z("div",{class:"fields"},z("h3",{},"Parameters"),v.map(L=>L.row));n.on("mode",y),n.on("units",()=>{[...s,...v,...P?[P]:[]].forEach(L=>L.show()),b()}),n.on("selection",_),n.on("reached",()=>{s.forEach(L=>L.show()),P?.show()}),n.on("tip",()=>e.mode==="reach"&&y()),y();let C=z("button",{type:"button",class:"quiet",onclick(){let L=V=>e[V].fill(0);["qdd","torque"].forEach(L),["pose","qd"].forEach(V=>E[V].forEach((k,K)=>e[V][K]=k));let{from:F,to:I,duration:O}=i;E.q.forEach((V,k)=>e.q[k]=F?.[k]??V),E.end.forEach((V,k)=>e.end[k]=I?.[k]??V),e.duration=O,n.setFields(Object.fromEntries(i.fields.map(({name:V,value:k})=>[V,k]))),y(),v.forEach(V=>V.show()),n.changed()}});C.append("Reset");let E={q:[...e.q],end:[...e.end],pose:[...e.pose],qd:[...e.qd]};return z("section",{class:"panel controls","aria-label":"Settings"},z("div",{class:"bar"},a,C),d,i.fields.length>0?D:null)}var xx=[[0,1],[0,2],[1,2]];function yx([n,e,t,i,s,r]){let o=[[n,i,r],[i,e,s],[r,s,t]],a=[[1,0,0],[0,1,0],[0,0,1]];for(let l=0;l<12;l++)for(let[c,h]of xx){if(o[c][h]===0)continue;let d=Math.atan2(2*o[c][h],o[h][h]-o[c][c])/2,[u,m]=[Math.sin(d),Math.cos(d)],g=x=>x.forEach(f=>[f[c],f[h]]=[m*f[c]-u*f[h],u*f[c]+m*f[h]]);g(o),[o[c],o[h]]=[o[c].map((x,f)=>m*x-u*o[h][f]),o[c].map((x,f)=>u*x+m*o[h][f])],g(a)}return{moments:[o[0][0],o[1][1],o[2][2]],axes:a}}function Ml({mass:n,inertia:e}){let{moments:t,axes:i}=yx(e),s=t[0]+t[1]+t[2],r=t.map(c=>n>0?Math.sqrt(Math.max(0,6*(s-2*c)/n))/2:0),[o,a,l]=[0,1,2].map(c=>i.map(h=>h[c]));return{x:o,y:a,z:l,half:r}}function vx(n,e){return n.rows.map(t=>t.joint!==null?e[t.joint]:t.follows?t.follows.factor*e[t.follows.joint]+t.follows.offset:t.locked)}function Ii(n,e,t){let i=t?gp(t):n.base?es(zs,n.base):zs,s=vx(n,e),r=[];n.rows.forEach((a,l)=>{let c=a.on===null?i:r[a.on].frame,h=a.step.reduce(es,c),d=a.type==="prismatic",u=a.theta+(d?0:s[l]),m=a.d+(d?s[l]:0),g=(f,p,M)=>{let P=a.mount?a.mount.frame.reduce(es,p):p;r.push({before:h,middle:f,frame:p,link:P,theta:u,d:m,origin:M.o,axis:M.z})};if(n.convention==="standard"){let f=pu(h,m,u);g(f,mu(f,a.a,a.alpha),h);return}let x=mu(h,a.a,a.alpha);g(x,pu(x,m,u),x)});let o=n.tips.map(({on:a,places:l})=>l.reduce(es,a===null?i:r[a].link));return{base:i,rows:r,tips:o}}function Tp(n,e){let t=new Array(n.joints).fill(0),{base:i,rows:s,tips:r}=Ii(n,t,null),o=[],a=u=>u===null?{way:0,at:i.o}:o[u],l=({way:u,at:m},g)=>({way:u+Qi(m,g),at:g});s.forEach(({middle:u,frame:m,link:g},x)=>{let{on:f,isPlace:p}=n.rows[x],M=n.isMounted?p?[]:[g.o]:[u.o,m.o];o.push(M.reduce(l,a(f)))});let c=n.tips.map(({on:u},m)=>l(a(u),r[m].o).way),h=Math.max(0,...o.map(({way:u})=>u),...c)+e,d=n.rows.map(u=>Math.hypot(...u.com));if(n.floating){let{com:u}=n.floating;d.push(Gt(Oe(u,Ml(n.floating).half)))}return Math.max(h,...d)||1}function Ap(n,e,t){let i=e.slice(0,6).map(a=>a.reduce((l,c,h)=>l+c*t[h],0)),[s,r]=[i.slice(0,3),i.slice(3)],o=be([e[1][5],e[2][3],e[0][4]],1/(e[0][0]||1));return{linear:xr(n,s),angular:xr(n,Pt(r,fn(o,s)))}}var Sx=["mass_matrix","coriolis_vector","kinetic_energy","friction_vector","spring_vector"];function Rp(n,e,t){let i=Object.keys(n).filter(o=>/^[a-z]/.test(o)),s=n.FIELD_NAMES!==void 0,r=o=>{let a=s?(...l)=>n[o](e,...l):n[o];return t||Sx.includes(o)?a:(l,...c)=>a(...c)};return Object.fromEntries(i.map(o=>[o,r(o)]))}function Cp(n,{base:e,q:t,qd:i,qdd:s,tau:r},{key:o}){let a=n.gravity_vector(e,t),l=n.friction_vector(i),c=n.spring_vector(t),h=n.mass_matrix(t),d=n.inverse_dynamics(e,t,i,i.map(()=>0));return{base:e,q:t,qd:i,qdd:s,tau:r,mass:h,momentum:e&&Ap(e,h,i),coriolis:d.map((u,m)=>u-a[m]-c[m]-l[m]),gravity:a,friction:l,spring:c,tip:n[o](e,t),kinetic:n.kinetic_energy(t,i),potential:n.potential_energy(e,t)}}var ia=2*Math.PI,Eu={cycloidal:n=>[n-Math.sin(ia*n)/ia,1-Math.cos(ia*n),ia*Math.sin(ia*n)],quintic:n=>[n**3*(10+n*(6*n-15)),30*n**2*(1-n)**2,60*n*(1-n)*(1-2*n)],cubic:n=>[n*n*(3-2*n),6*n*(1-n),6-12*n]};function Pp({from:n,to:e,duration:t,profile:i},s){let[r,o,a]=Eu[i](Math.min(Math.max(s/t,0),1)),l=c=>n.map((h,d)=>c(e[d]-h,h));return{q:l((c,h)=>h+c*r),qd:l(c=>c*o/t),qdd:l(c=>c*a/t**2)}}var Ip=1e-9,[bl,Mx]=[5,60],[Lp,Dp]=[.1,1e-12],bx=1e-9,[wx,Ex]=[120,.001],Tu=["x","y","z"];function Ru(n,e){let t=Tu.map(a=>fn(n[a],e[a])).reduce(Oe),i=1+Tu.reduce((a,l)=>a+hi(n[l],e[l]),0);if(i>1e-6)return be(t,1/Math.sqrt(i));let s=a=>Tu.reduce((l,c)=>Oe(l,be(e[c],n[c][a])),[0,1,2].map(l=>l===a?1:0)),o=[0,1,2].map(s).reduce((a,l)=>Gt(l)>Gt(a)?l:a);return be(o,2/Gt(o))}function Np(n,e){let t=new Set;for(let i=n.tips[e].on;i!==null;i=n.rows[i].on)t.add(n.rows[i].joint??n.rows[i].follows?.joint);return t.delete(void 0),t.size}function wl({table:n,base:e,tip:t},i){let{rows:s,tips:r}=Ii(n,i,e),o=i.map(()=>[0,0,0,0,0,0]);for(let a=n.tips[t].on;a!==null;a=n.rows[a].on){let{joint:l,follows:c,type:h}=n.rows[a],{joint:d,factor:u}=l===null?c??{joint:null}:{joint:l,factor:1};if(d===null)continue;let{axis:m,origin:g}=s[a],x=h==="prismatic"?[...m,0,0,0]:[...fn(m,Pt(r[t].o,g)),...m];o[d]=o[d].map((f,p)=>f+u*x[p])}return{frame:r[t],columns:o}}function Au(n,e){let{target:t,size:i,hasRotation:s}=n,{frame:r,columns:o}=wl(n,e),a=Pt(t.o,r.o),l=s?Ru(r,t):[0,0,0],c=[1,1,1].map(m=>m/i).concat(s?[1,1,1]:[0,0,0]),h=[...a,...l].map((m,g)=>m*c[g]),d=o.map(m=>m.map((g,x)=>g*c[x])),u=(m,g)=>m.reduce((x,f,p)=>x+f*g[p],0);return{way:Gt(a),turn:Gt(l),isReached:Gt(a)<=Ip&&Gt(l)<=Ip,error:u(h,h)/2,descent:d.map(m=>u(m,h)),matrix:d.map(m=>d.map(g=>u(m,g)))}}var Up=({matrix:n})=>Math.max(0,...n.map((e,t)=>e[t]));function Fp({limits:n},{matrix:e,descent:t},i,s){let r=e.map((l,c)=>l.map((h,d)=>c===d?h+i:h)),o=s.map(()=>0),a=s.map((l,c)=>c);for(let l=0;l<4&&a.length>0;l++){let c=t.map((u,m)=>s.reduce((g,x,f)=>a.includes(f)?g:g-r[m][f]*o[f],u)),h;try{h=Vs(r,c,a)}catch(u){if(u instanceof yr)return null;throw u}a.forEach((u,m)=>o[u]=sa(s[u]+h[m],n[u])-s[u]);let d=a.filter((u,m)=>o[u]===s[u]+h[m]-s[u]);if(d.length===a.length)break;a=d}return s.map((l,c)=>sa(l+o[c],n[c]))}var sa=(n,e)=>e?Math.min(Math.max(n,e[0]),e[1]):n;function ra(n,e){let t=e.map((s,r)=>sa(s,n.limits[r])),i=1/0;for(let s=0;;s++){let r=Au(n,t),o=s%bl===bl-1&&!(r.error<i/2);if(r.isReached||o||s===Mx)return{q:t,...r};s%bl===bl-1&&(i=r.error);let a=Up(r),l=Fp(n,r,Lp*Math.min(r.error,a)+Dp*a,t);if(l===null)return{q:t,...r};t=l}}function oa(n,e){let t=e.map((o,a)=>sa(o,n.limits[a])),i=Au(n,t),s=Up(i),r=Lp*s;for(let o=0;o<200&&!i.isReached&&r<1e9*s;o++){let a=Fp(n,i,r,t);if(a===null)break;let l=Au(n,a);i.error-l.error<bx*i.error?r*=4:[t,i,r]=[a,l,Math.max(r/4,Dp*s)]}return{q:t,...i}}function Tx(n){let e=n;return()=>{e=e+1831565813|0;let t=Math.imul(e^e>>>15,1|e);return t=t+Math.imul(t^t>>>7,61|t)^t,((t^t>>>14)>>>0)/2**32}}function Ax({table:n,limits:e},t,i){let s=o=>n.rows.some(({follows:a})=>a?.joint===o),r=n.rows.filter(({joint:o})=>o!==null);return t.map((o,a)=>{if(r[a].type!=="revolute"||s(a))return o;let l=2*Math.PI,c=o-l*Math.round((o-i[a])/l);return[c,c+l,c-l].find(d=>sa(d,e[a])===d)??o})}var Rx=(n,e)=>n.every((t,i)=>[0,2*Math.PI].some(s=>Math.abs(Math.abs(t-e[i])-s)<Ex));function Op(n,e,t=16){let i=Tx(1),s=()=>n.ranges.map(([l,c])=>l+(c-l)*i()),r=[],o=null;for(let l=0;l<wx&&r.length<t;l++){let c=ra(n,l===0?e:s());if((o===null||c.error<o.error)&&(o=c),!c.isReached)continue;let h=Ax(n,c.q,e);r.some(d=>Rx(h,d))||r.push(h)}let a=l=>Math.max(...l.map((c,h)=>Math.abs(c-e[h])));return r.sort((l,c)=>a(l)-a(c)),{found:r,nearest:r.length>0?null:oa(n,o.q)}}var Cu=[0,.05260015195876773,.0789002279381516,.1183503419072274,.2816496580927726,.3333333333333333,.25,.3076923076923077,.6512820512820513,.6,.8571428571428571,1],El=[[],[[0,.05260015195876773]],[[0,.0197250569845379],[1,.0591751709536137]],[[0,.02958758547680685],[2,.08876275643042054]],[[0,.2413651341592667],[2,-.8845494793282861],[3,.924834003261792]],[[0,.037037037037037035],[3,.17082860872947386],[4,.12546768756682242]],[[0,.037109375],[3,.17025221101954405],[4,.06021653898045596],[5,-.017578125]],[[0,.03709200011850479],[3,.17038392571223998],[4,.10726203044637328],[5,-.015319437748624402],[6,.008273789163814023]],[[0,.6241109587160757],[3,-3.3608926294469414],[4,-.868219346841726],[5,27.59209969944671],[6,20.154067550477894],[7,-43.48988418106996]],[[0,.47766253643826434],[3,-2.4881146199716677],[4,-.590290826836843],[5,21.230051448181193],[6,15.279233632882423],[7,-33.28821096898486],[8,-.020331201708508627]],[[0,-.9371424300859873],[3,5.186372428844064],[4,1.0914373489967295],[5,-8.149787010746927],[6,-18.52006565999696],[7,22.739487099350505],[8,2.4936055526796523],[9,-3.0467644718982196]],[[0,2.273310147516538],[3,-10.53449546673725],[4,-2.0008720582248625],[5,-17.9589318631188],[6,27.94888452941996],[7,-2.8589982771350235],[8,-8.87285693353063],[9,12.360567175794303],[10,.6433927460157636]],[[0,.054293734116568765],[5,4.450312892752409],[6,1.8915178993145003],[7,-5.801203960010585],[8,.3111643669578199],[9,-.1521609496625161],[10,.20136540080403034],[11,.04471061572777259]]],Bp=[[0,.01312004499419488],[5,-1.2251564463762044],[6,-.4957589496572502],[7,1.6643771824549864],[8,-.35032884874997366],[9,.3341791187130175],[10,.08192320648511571],[11,-.022355307863886294]],kp=[[0,.2440944881889764],[8,.7338466882816118],[11,.022058823529411766]];var Cx=1e-10;function aa(n,e,t,i){let s=Float64Array.from(n);for(let[r,o]of t){let a=i[r];for(let l=0;l<s.length;l++)s[l]+=e*o*a[l]}return s}function Tl(n,e,t,i,s){let r=[i];for(let g=1;g<Cu.length;g++)r.push(n(e+Cu[g]*s,aa(t,s,El[g],r)));let o=aa(t,s,El[12],r),a=new Float64Array(t.length),l=aa(a,1,El[12],r),c=aa(a,1,kp,r),h=aa(a,1,Bp,r),[d,u]=[0,0];for(let g=0;g<t.length;g++){let x=Cx*(1+Math.max(Math.abs(t[g]),Math.abs(o[g])));d+=(h[g]/x)**2/t.length,u+=((l[g]-c[g])/x)**2/t.length}let m=d===0?0:s*d/Math.sqrt(d+.01*u);return{end:o,error:m}}function Pu(n,e){if(!Number.isFinite(n))return 1/3;let t=.9*n**(-1/8);return Math.min(Math.max(t,1/3),e?1:6)}function Px(n){let e=Array.from({length:n.dof},()=>[]),t=n.dof-n.joints;for(let i of n.rows)i.joint!==null?e[t+i.joint].push({row:i,factor:1}):i.follows&&e[t+i.follows.joint].push({row:i,factor:i.follows.factor});return e}var zp=(n,e)=>e>0?n.coulomb[0]:n.coulomb[1],Ix=(n,e)=>n.stribeck?n.stribeck.friction:zp(n,e);function Vp(n){let e=Px(n);return{isDry:e.map(t=>t.some(({row:i})=>i.coulomb[0]!==0||i.coulomb[1]!==0||i.stribeck!==null)),breakaway:(t,i)=>e[t].reduce((s,{row:r,factor:o})=>s+Math.abs(o)*Ix(r,i*Math.sign(o)),0),sliding:(t,i,s)=>e[t].reduce((r,{row:o,factor:a})=>{let l=a*s,c=Math.sign(a)*i,h=zp(o,c),d=o.stribeck?(o.stribeck.friction-h)*Math.exp(-((l/o.stribeck.velocity)**2)):0;return r+a*(o.viscous*l+c*(h+d))},0)}}var Lx=6e5,Dx=200;function Nx(n,e){let t=e-(n.dof-n.joints);if(t<0)return"the mass matrix is singular at the base: no inertia resists its motion";let{name:i}=n.rows.find(s=>s.joint===t);return`the mass matrix is singular at joint ${t+1}, \`${i}\`: no inertia resists its motion`}var io=class extends Error{},Iu=class{constructor(e,t,i,s,r){cp(this,"rate",(e,t)=>{let i=this.state(t),{base:s,qd:r}=i,{tau:o,friction:a,qdd:l}=this.solve(i),c=r.reduce((h,d,u)=>h+d*(o[u]-a[u]),0);return this.chart?Float64Array.from([...this.chart.rate(t,s,r),...r.slice(this.ofBase),...l,c]):Float64Array.from([...r,...l,c])});this.chart=i&&new yl(i),this.ofBase=t.dof-t.joints,this.equations=e,this.torque=s,this.hasFriction=r,this.dry=Vp(t),this.dof=t.dof,this.evaluations=0,this.contacts=new Array(t.dof).fill(0),this.sticks=r&&this.dry.isDry.some(Boolean)}friction(e){return this.hasFriction?e.map((t,i)=>{let s=this.contacts[i];return s===null?0:this.dry.sliding(i,s||Math.sign(t),t)}):e.map(()=>0)}solve({base:e,q:t,qd:i}){if(++this.evaluations>Lx)throw new io("it takes too many steps");let s=this.torque(e,t,i),r=this.friction(i);if(!this.contacts.includes(null)){let g=this.equations.friction_vector(i),x=s.map((f,p)=>f+(g[p]-r[p]));return{tau:s,friction:r,qdd:this.equations.forward_dynamics(e,t,i,x),hold:null}}let o=i.map(()=>0),a=this.equations.friction_vector(i),l=this.equations.inverse_dynamics(e,t,i,o).map((g,x)=>g-a[x]),c=this.equations.mass_matrix(t),h=this.contacts.flatMap((g,x)=>g===null?[]:[x]),d=s.map((g,x)=>g-l[x]-r[x]),u=o;Vs(c,d,h).forEach((g,x)=>u[h[x]]=g);let m=s.map((g,x)=>this.contacts[x]!==null?0:c[x].reduce((f,p,M)=>f-p*u[M],g-l[x]));return{tau:s,friction:r,qdd:u,hold:m}}state(e){let t=this.dof;return{base:this.chart&&this.chart.pose(e),q:Array.from(e.subarray(this.ofBase,t)),qd:Array.from(e.subarray(t,2*t))}}margins(e){if(!this.sticks)return[1/0];let t=this.state(e),i=this.contacts.includes(null)?this.solve(t).hold:null;return this.contacts.map((s,r)=>s===null?this.dry.breakaway(r,Math.sign(i[r]))-Math.abs(i[r]):s===0?1/0:s*t.qd[r])}settle(e){if(!this.sticks)return;let t=this.state(e);for(this.contacts=t.qd.map((i,s)=>this.dry.isDry[s]?i===0?null:Math.sign(i):0);this.contacts.includes(null);){let{hold:i}=this.solve(t),s=this.contacts.map((o,a)=>o!==null||i[a]===0?0:Math.abs(i[a])/this.dry.breakaway(a,Math.sign(i[a]))),r=s.indexOf(Math.max(...s));if(!(s[r]>1))return;this.contacts[r]=Math.sign(i[r])}}};function Ux(n,e,t,i,s){let[r,o]=[0,s];for(let a=0;a<60&&o-r>1e-12*s;a++){let l=(r+o)/2,{end:c}=Tl(n.rate,e,t,i,l);Math.min(...n.margins(c))<0?o=l:r=l}return o}function Fx(n,e,t){let{t:i,y:s,h:r}=e,o=0,a=!1;for(;t-i>1e-12*Math.max(1,t);){let l=n.rate(i,s),c=Math.min(r,t-i),{end:h,error:d}=Tl(n.rate,i,s,l,c);if(!(d<=1)){if(r=c*Pu(d,!0),a=!0,!(r>1e-12))throw new io("its steps become too small");continue}if(Math.min(...n.margins(h))<0){if(++o>Dx)throw new io("a joint sticks and lets go without end");let m=Ux(n,i,s,l,c);s=Tl(n.rate,i,s,l,m).end,i+=m,n.chart?.recenter(s),n.contacts.forEach((g,x)=>{g&&g*s[n.dof+x]<=0&&(s[n.dof+x]=0)}),n.settle(s);continue}[i,s]=[i+c,h],n.chart?.recenter(s);let u=c*Pu(d,a);r=c<r&&d<.1?Math.max(r,u):u,a=!1}return{t,y:s,h:r}}function Gp({equations:n,table:e,law:t,torque:i,hasFriction:s,base:r,q:o,qd:a,duration:l,samples:c}){let h=Sp[t]({equations:n,torque:i,hasFriction:s}),d=new Iu(n,e,r,h,s),u={t:[],base:[],q:[],qd:[],qdd:[],tau:[],work:[],ended:null},m={t:0,y:Float64Array.from([...d.chart?.start??[],...o,...a,0]),h:l/c};try{d.settle(m.y);for(let g=0;g<c;g++){let x=l*g/(c-1);m=Fx(d,m,x);let f=d.state(m.y),{qdd:p,tau:M}=d.solve(f);u.t.push(x),u.base.push(f.base),u.q.push(f.q),u.qd.push(f.qd),u.qdd.push(p),u.tau.push(M),u.work.push(m.y[2*d.dof])}}catch(g){let x=g instanceof yr||g.name==="SingularMassMatrix";if(!(g instanceof io)&&!x)throw g;u.ended={t:m.t,reason:x?Nx(e,g.joint):g.message}}return u}var Ox=100,[Bx,kx]=[201,2001];function Al(n){return Math.min(Math.max(Math.round(Ox*n)+1,Bx),kx)}function Hp(n,e){let t=Al(e.duration),{base:i}=e,s=i?eo.map(()=>0):[],r=h=>{let{q:d,...u}=Pp(e,h),[m,g]=[u.qd,u.qdd].map(x=>[...s,...x]);return{base:i,q:d,qd:m,qdd:g,tau:n.inverse_dynamics(i,d,m,g)}},o=Array.from({length:t},(h,d)=>e.duration*d/(t-1)),a=o.map(r),l=h=>a.map(d=>d[h]),c={t:o,base:l("base"),q:l("q"),qd:l("qd"),qdd:l("qdd"),tau:l("tau")};return Rl(n,{...c,at:r,ended:null,duration:e.duration},e)}function Wp(n,e){let t=Gp({...e,equations:n,samples:Al(e.duration)});t.t.length===0&&zx(t,e);let i=t.t.length>0?t.t[t.t.length-1]:0,s=Rl(n,{...t,duration:i,at:h=>Lu(t,h)},e),{total:r,kinetic:o,potential:a}=s,l=r.map((h,d)=>Math.abs(h-r[0]-t.work[d])),c=h=>Math.max(...h)-Math.min(...h);return s.drift=Math.max(0,...l),s.energyScale=Math.max(c(o),c(a),c(t.work),0),s}function zx(n,{base:e,q:t,qd:i}){let s=i.map(()=>NaN);for(let[r,o]of Object.entries({t:0,base:e,q:t,qd:i,qdd:s,tau:s,work:0}))n[r].push(o)}function Rl(n,e,{key:t}){let{base:i,q:s,qd:r}=e,o=s.map((h,d)=>n.kinetic_energy(h,r[d])),a=s.map((h,d)=>n.potential_energy(i[d],h)),l=o.map((h,d)=>h+a[d]),c=s.map((h,d)=>n[t](i[d],h).slice(0,3).map(u=>u[3]));return{...e,kinetic:o,potential:a,total:l,tip:c}}function Lu(n,e){let{t}=n,i=t.length-1,s=m=>Object.fromEntries(["base","q","qd","qdd","tau"].map(g=>[g,n[g][m]]));if(i<1)return s(0);let r=t[1]-t[0],o=Math.min(Math.max(Math.floor(e/r),0),i-1),a=Math.min(Math.max((e-t[o])/r,0),1);if(a===0||a===1)return s(o+a);let[l,c]=[s(o),s(o+1)],h=l.qd.length-l.q.length,d=(m,g,x)=>l[m].map((f,p)=>f+vu(c[m][p]-f,r*l[g][x+p],r*c[g][x+p],a)),u=m=>m[o].map((g,x)=>g+a*(m[o+1][x]-g));return{base:l.base&&_p([l.base,c.base],[l.qd,c.qd],r,a),q:d("q","qd",h),qd:d("qd","qdd",0),qdd:u(n.qdd),tau:u(n.tau)}}function Xp(n,e){let t=["q","qd","qdd","tau"],[i]=n.base,s=h=>e.slice(e.length-n[h][0].length),r=t.flatMap(h=>s(h).map(d=>`${h}_${d}`)),a=[...[1,2,3].flatMap(h=>[1,2,3].map(d=>`r${h}${d}`)),"x","y","z"].map(h=>`base.${h}`),l=["t",...i?a:[],...r,"kinetic","potential","x","y","z"],c=n.t.map((h,d)=>[h,...n.base[d]??[],...t.flatMap(u=>n[u][d]),n.kinetic[d],n.potential[d],...n.tip[d]]);return[l,...c].map(h=>h.join(",")).join(`
`)+`
`}var Vx=.3;function Gx(n,e,t){let{columns:i}=wl(n,e),s=n.hasRotation?6:3,r=(a,l)=>a.slice(0,s).reduce((c,h,d)=>c+h*l[d],0),o=i.map((a,l)=>i.map((c,h)=>r(a,c)+(l===h?1e-10:0)));return Vs(o,i.map(a=>r(a,t)),e.map((a,l)=>l))}function Hx(n,e){let t=n.length-1,i=(s,r)=>n[0].map((o,a)=>r.reduce((l,[c,h])=>l+h*n[s+c][a],0)/(2*e));return n.map((s,r)=>r===0?i(0,[[0,-3],[1,4],[2,-1]]):r===t?i(t,[[0,3],[-1,-4],[-2,1]]):i(r,[[1,1],[-1,-1]]))}function qp(n,e,t){let{from:i,duration:s,profile:r,base:o}=t,a=Al(s),l=s/(a-1),{frame:c}=wl(e,i),h=Pt(e.target.o,c.o),d=Ru(c,e.target),u=e.hasRotation?2*Math.asin(Math.min(1,Gt(d)/2)):0,m=On(d),g={t:[],base:[],q:[],qd:[],ended:null},x=i;for(let f=0;f<a;f++){let[p,M]=Eu[r](f/(a-1)),P=v=>gr(v,m,u*p),y={x:P(c.x),y:P(c.y),z:P(c.z),o:Oe(c.o,be(h,p))},A={...e,target:y},b=ra(A,x);b.isReached||(b=oa(A,x));let _=Wx(e,x,b);if(_&&f>0){g.ended={t:f*l,reason:_};break}x=b.q,g.t.push(f*l),g.base.push(o),g.q.push(x),g.qd.push(Gx(e,x,[...be(h,M/s),...be(m,u*M/s)]))}return Xx(n,g,l,t)}function Wx({size:n,joints:e},t,i){return i.isReached?t.some((r,o)=>Math.abs(i.q[o]-r)>Vx*(e[o].type==="revolute"?1:n))?"the line passes a singular pose, where the joints would have to jump":null:"the line leaves what the arm reaches within its limits, or meets a singular pose"}function Xx(n,e,t,{base:i,key:s}){let r=i?[0,0,0,0,0,0]:[],a=e.t.length>2?Hx(e.qd,t):e.qd.map(d=>d.map(()=>0)),l=d=>d.map(u=>[...r,...u]),c={...e,qd:l(e.qd),qdd:l(a)};c.tau=c.q.map((d,u)=>n.inverse_dynamics(i,d,c.qd[u],c.qdd[u]));let h=c.t[c.t.length-1];return Rl(n,{...c,duration:h,at:d=>Lu(c,d)},{key:s})}var Zp=n=>typeof n=="number"?[n]:n&&typeof n=="object"?Object.values(n).flatMap(Zp):[];function Yp([n,e,t,i,s,r],o){return[[[n,e,t],o],[[n*e-i*i,e*t-s*s,n*t-r*r],o**2],[[n*(e*t-s*s)-i*(i*t-s*r)+r*(i*s-e*r)],o**3]].every(([l,c])=>l.every(h=>h>=-1e-9*c))}function qx([n,e,t,i,s,r]){let o=Math.max(...[n,e,t,i,s,r].map(Math.abs));if([n,e,t].filter(c=>c!==0).length<2&&Math.min(n,e,t)>=0&&i===0&&s===0&&r===0)return null;let a=(n+e+t)/2;return Yp([n,e,t,i,s,r],o)&&Yp([a-n,a-e,a-t,-i,-s,-r],o)?null:"no body has this inertia tensor"}function $p(n){if(Zp(n).some(t=>!Number.isFinite(t)))return"division by zero, or a number that is too large";let e=[[n.mass,"a mass"],[n.motorInertia,"a motor's inertia"],[n.viscous,"a friction coefficient"],[Math.min(...n.coulomb??[]),"a friction torque or force"],[n.stribeck?.friction,"a friction torque or force"],[n.spring?.stiffness,"a spring's stiffness"]].find(([t])=>t<0);return e?`${e[1]} cannot be negative`:n.motorInertia>0&&n.gearRatio===0?"a gear ratio of zero: a motor with inertia turns with its joint":n.stribeck&&!(n.stribeck.velocity>0)?"a Stribeck velocity is above zero":qx(n.inertia)}function jp(n,e){let t=({rows:s,tool:r,base:o,floating:a,gravity:l})=>[...s,r,a,o&&{inertia:[0,0,0,0,0,0],base:o},{inertia:[0,0,0,0,0,0],gravity:l}],i=t(e);for(let[s,r]of t(n).entries()){let o=r&&$p(r);if(o&&o!==$p(i[s]))return r.name?`\`${r.name}\`: ${o}`:o}return null}function Jp(){let n=new Map;return{on(e,t){for(let i of e.split(" "))n.set(i,[...n.get(i)??[],t])},tell(e){(n.get(e)??[]).forEach(t=>t())}}}var Yx=30;function $x(n,e){return n.limits?n.limits:n.type==="revolute"?[-Math.PI,Math.PI]:[-e,e]}function Zx([n,e]){return n<=0&&e>=0?0:(n+e)/2}var Kp=[0,0,0,.1,1.5,.3],Qp=[60,40,-50,30,70,-40];function jx(n,{type:e,joint:t},[i,s]){let r=Qp[t%Qp.length],o=e==="revolute"?r*Math.PI/180:(s-i)*r/240,[a,l]=[n+o,n-o],c=h=>h>=i&&h<=s;return c(a)?a:c(l)?l:o>0?s:i}function em(n,e,t){let{on:i,tell:s}=Jp(),r=Object.fromEntries(t.fields.map(({name:y,value:A})=>[y,A])),o=n(r),a=o.floating!==null,l=Rp(e,r,a),c=o.rows.filter(y=>y.type==="prismatic"&&y.joint!==null).reduce((y,A)=>y+(A.limits?Math.max(...A.limits.map(Math.abs)):0),0),h=Tp(o,c),d=o.rows.filter(y=>y.joint!==null),u=d.map(y=>$x(y,h)),m=[...a?eo:[],...d],g=m.map(()=>0),x=t.from??u.map(Zx),f={mode:"motion",pose:[...t.pose??[0,0,0,0,0,0]],q:[...x],qd:[...t.velocity??(a?[...Kp,...g.slice(Kp.length)]:g)],qdd:[...g],end:t.to??x.map((y,A)=>jx(y,d[A],u[A])),torque:[...g],target:null,hasRotation:!0,path:"joints",reached:{found:[],chosen:0,missing:null},isDragged:!1,profile:"cycloidal",law:"none",hasFriction:!0,duration:t.duration,t:0,isPlaying:!1,isRepeated:!1,speed:1,selected:o.rows.indexOf(d[0]),tip:0,show:{parameters:"selected",frames:!1,axes:!1,masses:!1,trace:!0,names:!1,isFollowed:!0}},p={on:i,tell:s,state:f,first:t,fields:r,equations:l,table:o,size:h,joints:d,freedoms:m,ofBase:m.length-d.length,ranges:u,trajectory:null,units:fu(!0),now(){if(f.mode==="pose"){let{q:y,qd:A,qdd:b}=f,_=p.start();return{base:_,q:y,qd:A,qdd:b,tau:l.inverse_dynamics(_,y,A,b)}}return p.trajectory.at(f.t)},start:()=>a?mp(f.pose):null,tip:()=>o.tips[f.tip],evaluated:()=>Cp(l,p.now(),p.tip()),frames(){let{base:y,q:A}=p.now();return Ii(p.table,A,y)},setTime(y){let A=p.trajectory?.duration??0;f.t=Math.min(Math.max(y,0),A),s("time")},play(y){p.trajectory&&(f.isPlaying=y,y&&f.t>=p.trajectory.duration&&p.setTime(0),s("play"))},problem(){let{hasRotation:y,tip:A,target:b}=f,[_,v,D,...C]=b,E=es(zs,{xyz:[_,v,D],rpy:C}),L=d.map(F=>F.limits);return{table:p.table,base:p.start(),tip:A,target:E,hasRotation:y,limits:L,ranges:u,joints:d,size:h}},seek(y=!1){let A=p.problem();if(f.isDragged=y,y){let b=ra(A,f.end),{q:_,isReached:v,...D}=b.isReached?b:oa(A,f.end);f.end=_,f.reached={found:v?[_]:[],chosen:0,missing:v?null:D}}else{let{found:b,nearest:_}=Op(A,f.end);f.reached={found:b,chosen:0,missing:_},f.end=b[0]??_.q}f.isPlaying=!1,p.recompute(),p.setTime(p.trajectory.duration),s("reached"),s("play")},choose(y,A=!1){let{found:b}=f.reached;A?b[y].forEach((_,v)=>f.q[v]=_):[f.end,f.reached.chosen]=[[...b[y]],y],s("reached"),p.changed()},placeTarget(){let{tips:y}=Ii(p.table,f.end,p.start()),{x:A,y:b,z:_,o:v}=y[f.tip];f.hasRotation=Np(p.table,f.tip)>=6,f.target=[...v,...Qr([0,1,2].map(D=>[A[D],b[D],_[D]]))]},setMode(y){if(f.mode=y,y==="reach"){p.placeTarget(),p.seek(),f.t=0,s("mode"),s("time");return}f.isPlaying=!1,f.t=0,p.recompute(),s("mode"),s("time"),s("play")},changed(){f.isPlaying=!1,f.t=0,s("play"),p.ask()},setFields(y){let A=n({...r,...y}),b=jp(A,o);return b||(Object.assign(r,y),p.table=A,s("fields"),f.mode==="reach"?p.seek():p.changed(),null)},setUnits(y){p.units=fu(y),s("units")},select(y){f.selected=y,s("selection")},setTip(y){f.tip=y,f.mode==="reach"?(p.placeTarget(),p.seek()):p.recompute(),s("tip")},setShown(y){Object.assign(f.show,y),s("show")},recompute(){let y=performance.now(),{q:A,qd:b,end:_,torque:v,profile:D,law:C,hasFriction:E,duration:L}=f,{table:F}=p,I=p.start(),{key:O}=p.tip(),V=f.mode==="reach";p.trajectory=V&&f.path==="line"&&!f.isDragged?qp(l,p.problem(),{base:I,from:[...A],duration:L,profile:D,key:O}):f.mode==="motion"||V?Hp(l,{base:I,from:[...A],to:[..._],duration:L,profile:D,key:O}):f.mode==="free"?Wp(l,{table:F,law:C,hasFriction:E,duration:L,key:O,base:I,q:[...A],qd:[...b],torque:[...v]}):null,M=performance.now()-y,P=void 0,s("trajectory"),s("time")},isStale:()=>P!==void 0,ask(){clearTimeout(P),P=setTimeout(p.recompute,M>Yx?160:0)}},[M,P]=[0,void 0];return p.recompute(),p}var Jx="uplot",Kx="u-hz",Qx="u-vt",ey="u-title",ty="u-wrap",ny="u-under",iy="u-over",sy="u-axis",Mr="u-off",ry="u-select",oy="u-cursor-x",ay="u-cursor-y",ly="u-cursor-pt",cy="u-legend",hy="u-live",uy="u-inline",dy="u-series",fy="u-marker",tm="u-label",py="u-value",ca="width",ha="height";var nm="bottom",so="left",Du="right",ju="#000",im=ju+"0",Nu="mousemove",sm="mousedown",Uu="mouseup",rm="mouseenter",om="mouseleave",am="dblclick",my="resize",gy="scroll",lm="change",Dl="dppxchange",Ju="--",uo=typeof window<"u",zu=uo?document:null,oo=uo?window:null,_y=uo?navigator:null,At,Cl;function Vu(){let n=devicePixelRatio;At!=n&&(At=n,Cl&&Hu(lm,Cl,Vu),Cl=matchMedia(`(min-resolution: ${At-.001}dppx) and (max-resolution: ${At+.001}dppx)`),br(lm,Cl,Vu),oo.dispatchEvent(new CustomEvent(Dl)))}function ui(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Gu(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function $t(n,e,t){n.style[e]=t+"px"}function Li(n,e,t,i){let s=zu.createElement(n);return e!=null&&ui(s,e),t?.insertBefore(s,i),s}function Mi(n,e){return Li("div",n,e)}var cm=new WeakMap;function ns(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=cm.get(n);r!=o&&(n.style.transform=r,cm.set(n,r),e<0||t<0||e>i||t>s?ui(n,Mr):Gu(n,Mr))}var hm=new WeakMap;function um(n,e,t){let i=e+t,s=hm.get(n);i!=s&&(hm.set(n,i),n.style.background=e,n.style.borderColor=t)}var dm=new WeakMap;function fm(n,e,t,i){let s=e+""+t,r=dm.get(n);s!=r&&(dm.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var Ku={passive:!0},xy={...Ku,capture:!0};function br(n,e,t,i){e.addEventListener(n,t,i?xy:Ku)}function Hu(n,e,t,i){e.removeEventListener(n,t,Ku)}uo&&Vu();function Di(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:di((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function Vm(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var Gm=n=>n!=null,Hm=n=>n!=null&&n>0,Fl=Vm(Gm),yy=Vm(Hm);function vy(n,e,t,i=0,s=!1){let r=s?yy:Fl,o=s?Hm:Gm;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let h=n[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??zt,l??-zt]}function Ol(n,e,t,i){let s=gm(n),r=gm(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?xs:Wm,a=s==1?di:bi,l=r==1?bi:di,c=a(o(vn(n))),h=l(o(vn(e))),d=ao(t,c),u=ao(t,h);return t==10&&(c<0&&(d=Vt(d,-c)),h<0&&(u=Vt(u,-h))),i||t==2?(n=d*s,e=u*r):(n=$m(n,d),e=Bl(e,u)),[n,e]}function Qu(n,e,t,i){let s=Ol(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var ed=.1,pm={mode:3,pad:ed},da={pad:0,soft:null,mode:0},Sy={min:da,max:da};function Nl(n,e,t,i){return kl(t)?mm(n,e,t):(da.pad=t,da.soft=i?0:null,da.mode=i?3:0,mm(n,e,Sy))}function wt(n,e){return n??e}function My(n,e,t){for(e=wt(e,0),t=wt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function mm(n,e,t){let i=t.min,s=t.max,r=wt(i.pad,0),o=wt(s.pad,0),a=wt(i.hard,-zt),l=wt(s.hard,zt),c=wt(i.soft,zt),h=wt(s.soft,-zt),d=wt(i.mode,0),u=wt(s.mode,0),m=e-n,g=xs(m),x=Yn(vn(n),vn(e)),f=xs(x),p=vn(f-g);(m<1e-24||p>10)&&(m=0,(n==0||e==0)&&(m=1e-24,d==2&&c!=zt&&(r=0),u==2&&h!=-zt&&(o=0)));let M=m||x||1e3,P=xs(M),y=ao(10,di(P)),A=M*(m==0?n==0?.1:1:r),b=Vt($m(n-A,y/10),24),_=n>=c&&(d==1||d==3&&b<=c||d==2&&b>=c)?c:zt,v=Yn(a,b<_&&n>=_?_:Ni(_,b)),D=M*(m==0?e==0?.1:1:o),C=Vt(Bl(e+D,y/10),24),E=e<=h&&(u==1||u==3&&C>=h||u==2&&C<=h)?h:-zt,L=Ni(l,C>E&&e<=E?E:Yn(E,C));return v==L&&v==0&&(L=100),[v,L]}var by=new Intl.NumberFormat(uo?_y.language:"en-US"),td=n=>by.format(n),fi=Math,Ll=fi.PI,vn=fi.abs,di=fi.floor,yn=fi.round,bi=fi.ceil,Ni=fi.min,Yn=fi.max,ao=fi.pow,gm=fi.sign,xs=fi.log10,Wm=fi.log2,wy=(n,e=1)=>fi.sinh(n)*e,Fu=(n,e=1)=>fi.asinh(n/e),zt=1/0;function _m(n){return(xs((n^n>>31)-(n>>31))|0)+1}function Wu(n,e,t){return Ni(Yn(n,e),t)}function Xm(n){return typeof n=="function"}function yt(n){return Xm(n)?n:()=>n}var Ey=()=>{},qm=n=>n,Ym=(n,e)=>e,Ty=n=>null,xm=n=>!0,ym=(n,e)=>n==e,Ay=/\.\d*?(?=9{6,}|0{6,})/gm,wr=n=>{if(jm(n)||Hs.has(n))return n;let e=`${n}`,t=e.match(Ay);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${wr(s)}e${r}`}return Vt(n,i)};function vr(n,e){return wr(Vt(wr(n/e))*e)}function Bl(n,e){return wr(bi(wr(n/e))*e)}function $m(n,e){return wr(di(wr(n/e))*e)}function Vt(n,e=0){if(jm(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return yn(i)/t}var Hs=new Map;function Zm(n){return((""+n).split(".")[1]||"").length}function pa(n,e,t,i){let s=[],r=i.map(Zm);for(let o=e;o<t;o++){let a=vn(o),l=Vt(ao(n,o),a);for(let c=0;c<i.length;c++){let h=n==10?+`${i[c]}e${o}`:i[c]*l,d=(o>=0?0:a)+(o>=r[c]?0:r[c]),u=n==10?h:Vt(h,d);s.push(u),Hs.set(u,d)}}return s}var fa={},nd=[],lo=[null,null],Gs=Array.isArray,jm=Number.isInteger,Ry=n=>n===void 0;function vm(n){return typeof n=="string"}function kl(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function Cy(n){return n!=null&&typeof n=="object"}var Py=Object.getPrototypeOf(Uint8Array),Jm="__proto__";function co(n,e=kl){let t;if(Gs(n)){let i=n.find(s=>s!=null);if(Gs(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=co(n[s],e)}else t=n.slice()}else if(n instanceof Py)t=n.slice();else if(e(n)){t={};for(let i in n)i!=Jm&&(t[i]=co(n[i],e))}else t=n;return t}function pn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=Jm&&(kl(n[s])?pn(n[s],co(i[s])):n[s]=co(i[s]))}return n}var Iy=0,Ly=1,Dy=2;function Ny(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function Uy(n,e){if(By(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return ky(o[0])||(o=Oy(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],d=Array(s).fill(void 0),u=e?e[o][c]:Ly,m=[];for(let g=0;g<h.length;g++){let x=h[g],f=r.get(l[g]);x===null?u!=Iy&&(d[f]=x,u==Dy&&m.push(f)):d[f]=x}Ny(d,m,s),i.push(d)}}return i}var Fy=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Oy(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function By(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function ky(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Yn(1,di((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Km=["January","February","March","April","May","June","July","August","September","October","November","December"],Qm=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function eg(n){return n.slice(0,3)}var zy=Qm.map(eg),Vy=Km.map(eg),Gy={MMMM:Km,MMM:Vy,WWWW:Qm,WWW:zy};function la(n){return(n<10?"0":"")+n}function Hy(n){return(n<10?"00":n<100?"0":"")+n}var Wy={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>la(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>la(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>la(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>la(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>la(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>Hy(n.getMilliseconds())};function id(n,e){e=e||Gy;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?Wy[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var Xy=new Intl.DateTimeFormat().resolvedOptions().timeZone;function qy(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==Xy?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var tg=n=>n%1==0,Ul=[1,2,2.5,5],Yy=pa(10,-32,0,Ul),ng=pa(10,0,32,Ul),$y=ng.filter(tg),Sr=Yy.concat(ng),sd=`
`,ig="{YYYY}",Sm=sd+ig,sg="{M}/{D}",ua=sd+sg,Pl=ua+"/{YY}",rg="{aa}",Zy="{h}:{mm}",ro=Zy+rg,Mm=sd+ro,bm=":{ss}",It=null;function og(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?pa(10,0,3,Ul).filter(tg):pa(10,-3,0,Ul)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,ig,It,It,It,It,It,It,1],[s*28,"{MMM}",Sm,It,It,It,It,It,1],[s,sg,Sm,It,It,It,It,It,1],[i,"{h}"+rg,Pl,It,ua,It,It,It,1],[t,ro,Pl,It,ua,It,It,It,1],[e,bm,Pl+" "+ro,It,ua+" "+ro,It,Mm,It,1],[n,bm+".{fff}",Pl+" "+ro,It,ua+" "+ro,It,Mm,It,1]];function h(d){return(u,m,g,x,f,p)=>{let M=[],P=f>=o,y=f>=r&&f<o,A=d(g),b=Vt(A*n,3),_=Ou(A.getFullYear(),P?0:A.getMonth(),y||P?1:A.getDate()),v=Vt(_*n,3);if(y||P){let D=y?f/r:0,C=P?f/o:0,E=b==v?b:Vt(Ou(_.getFullYear()+C,_.getMonth()+D,1)*n,3),L=new Date(yn(E/n)),F=L.getFullYear(),I=L.getMonth();for(let O=0;E<=x;O++){let V=Ou(F+C*O,I+D*O,1),k=V-d(Vt(V*n,3));E=Vt((+V+k)*n,3),E<=x&&M.push(E)}}else{let D=f>=s?s:f,C=di(g)-di(b),E=v+C+Bl(b-v,D);M.push(E);let L=d(E),F=L.getHours()+L.getMinutes()/t+L.getSeconds()/i,I=f/i,O=u.axes[m]._space,V=p/O;for(;E=Vt(E+f,n==1?0:3),!(E>x);)if(I>1){let k=di(Vt(F+I,6))%24,Z=d(E).getHours()-k;Z>1&&(Z=-1),E-=Z*i,F=(F+I)%24;let te=M[M.length-1];Vt((E-te)/f,3)*V>=.7&&M.push(E)}else M.push(E)}return M}}return[l,c,h]}var[jy,Jy,Ky]=og(1),[Qy,ev,tv]=og(.001);pa(2,-53,53,[1]);function wm(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function Em(n,e){return(t,i,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,h,d,u,m;return i.map(g=>{let x=n(g),f=x.getFullYear(),p=x.getMonth(),M=x.getDate(),P=x.getHours(),y=x.getMinutes(),A=x.getSeconds(),b=f!=l&&a[2]||p!=c&&a[3]||M!=h&&a[4]||P!=d&&a[5]||y!=u&&a[6]||A!=m&&a[7]||a[1];return l=f,c=p,h=M,d=P,u=y,m=A,b(x)})}}function nv(n,e){let t=id(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Ou(n,e,t){return new Date(n,e,t)}function Tm(n,e){return e(n)}var iv="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Am(n,e){return(t,i,s,r)=>r==null?Ju:e(n(i))}function sv(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function rv(n,e){return n.series[e].fill(n,e)}var ov={show:!0,live:!0,isolate:!1,mount:Ey,markers:{show:!0,width:2,stroke:sv,fill:rv,dash:"solid"},idx:null,idxs:null,values:[]};function av(n,e){let t=n.cursor.points,i=Mi(),s=t.size(n,e);$t(i,ca,s),$t(i,ha,s);let r=s/-2;$t(i,"marginLeft",r),$t(i,"marginTop",r);let o=t.width(n,e,s);return o&&$t(i,"borderWidth",o),i}function lv(n,e){let t=n.series[e].points;return t._fill||t._stroke}function cv(n,e){let t=n.series[e].points;return t._stroke||t._fill}function hv(n,e){return n.series[e].points.size}var Bu=[0,0];function uv(n,e,t){return Bu[0]=e,Bu[1]=t,Bu}function Il(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function ku(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var dv={show:!0,x:!0,y:!0,lock:!1,move:uv,points:{one:!1,show:av,size:hv,width:0,stroke:cv,fill:lv},bind:{mousedown:Il,mouseup:Il,click:Il,dblclick:Il,mousemove:ku,mouseleave:ku,mouseenter:ku},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},ag={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},rd=pn({},ag,{filter:Ym}),lg=pn({},rd,{size:10}),cg=pn({},ag,{show:!1}),od='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',hg="bold "+od,ug=1.5,Rm={show:!0,scale:"x",stroke:ju,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:hg,side:2,grid:rd,ticks:lg,border:cg,font:od,lineGap:ug,rotate:0},fv="Value",pv="Time",Cm={show:!0,scale:"x",auto:!1,sorted:1,min:zt,max:-zt,idxs:[]};function mv(n,e,t,i,s){return e.map(r=>r==null?"":td(r))}function gv(n,e,t,i,s,r,o){let a=[],l=Hs.get(s)||0;t=o?t:Vt(Bl(t,s),l);for(let c=t;c<=i;c=Vt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Xu(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?xs:Wm,h=di(c(t));s=ao(l,h),l==10&&(s=Sr[Di(s,Sr)]);let d=t,u=s*l;l==10&&(u=Sr[Di(u,Sr)]);do a.push(d),d=d+s,l==10&&!Hs.has(d)&&(d=Vt(d,Hs.get(s))),d>=u&&(s=d,u=s*l,l==10&&(u=Sr[Di(u,Sr)]));while(d<=i);return a}function _v(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Xu(n,e,Yn(l,t),i,s):[l],h=i>=0&&t<=0?[0]:[];return(t<-l?Xu(n,e,Yn(l,-i),-t,s):[l]).reverse().map(u=>-u).concat(h,c)}var dg=/./,xv=/[12357]/,yv=/[125]/,Pm=/1/,qu=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function vv(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,h=l(10,o),d=l(9,o)-h>=c?dg:l(7,o)-h>=c?xv:l(5,o)-h>=c?yv:Pm;if(d==Pm){let u=vn(l(1,o)-h);if(u<c)return qu(e.slice().reverse(),a.distr,d,bi(c/u)).reverse()}return qu(e,a.distr,d,1)}function Sv(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=vn(l(1,o)-l(2,o));return c<a?qu(e.slice().reverse(),3,dg,bi(a/c)).reverse():e}function Mv(n,e,t,i){return i==null?Ju:e==null?"":td(e)}var Im={show:!0,scale:"y",stroke:ju,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:hg,side:3,grid:rd,ticks:lg,border:cg,font:od,lineGap:ug,rotate:0};function bv(n,e){let t=3+(n||1)*2;return Vt(t*e,3)}function wv(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=vn(o-r),l=n.series[e],c=a/(l.points.space*At);return i[1]-i[0]<=c}var Lm={scale:null,auto:!0,sorted:0,min:zt,max:-zt},fg=(n,e,t,i,s)=>s,Dm={show:!0,auto:!0,sorted:0,gaps:fg,alpha:1,facets:[pn({},Lm,{scale:"x"}),pn({},Lm,{scale:"y"})]},Nm={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:fg,alpha:1,points:{show:wv,filter:null},values:null,min:zt,max:-zt,idxs:[],path:null,clip:null};function Ev(n,e,t,i,s){return t/10}var pg={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Tv=pn({},pg,{time:!1,ori:1}),Um={};function mg(n,e){let t=Um[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(i,s,r,o,a,l,c)}},n!=null&&(Um[n]=t)),t}var ho=1,Yu=2;function Er(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],h=i==2?o[s.facets[0].scale]:o[n.series[0].scale],d=i==2?o[s.facets[1].scale]:o[s.scale],u=a.left,m=a.top,g=a.width,x=a.height,f=n.valToPosH,p=n.valToPosV;return h.ori==0?t(s,l,c,h,d,f,p,u,m,g,x,Vl,fo,Hl,_g,yg):t(s,l,c,h,d,p,f,m,u,x,g,Gl,po,cd,xg,vg)}function ad(n,e){let t=0,i=0,s=wt(n.bands,nd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function Av(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ys(n,e,t,i,s,r){return Er(n,e,(o,a,l,c,h,d,u,m,g,x,f)=>{let p=o.pxRound,M=c.dir*(c.ori==0?1:-1),P=c.ori==0?fo:po,y,A;M==1?(y=t,A=i):(y=i,A=t);let b=p(d(a[y],c,x,m)),_=p(u(l[y],h,f,g)),v=p(d(a[A],c,x,m)),D=p(u(r==1?h.max:h.min,h,f,g)),C=new Path2D(s);return P(C,v,D),P(C,b,D),P(C,b,_),C})}function zl(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?Hl:cd,l=t;for(let d=0;d<n.length;d++){let u=n[d];if(u[1]>u[0]){let m=u[0]-l;m>0&&a(o,l,i,m,i+r),l=u[1]}}let c=t+s-l,h=10;c>0&&a(o,l,i-h/2,c,i+r+h)}return o}function Rv(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function ld(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let d=c,u=c;if(s==1)for(;++c<=i&&e[c]===null;)u=c;else for(;--c>=t&&e[c]===null;)u=c;let m=r(n[d]),g=u==d?m:r(n[u]),x=d-s;m=o<=0&&x>=0&&x<l?r(n[x]):m;let p=u+s;g=o>=0&&p>=0&&p<l?r(n[p]):g,g>=m&&a.push([m,g])}return a}function Fm(n){return n==0?qm:n==1?yn:e=>vr(e,n)}function gg(n){let e=n==0?Vl:Gl,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?i(s,r,o,a,l):(c=Ni(c,a/2,l/2),h=Ni(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var Vl=(n,e,t)=>{n.moveTo(e,t)},Gl=(n,e,t)=>{n.moveTo(t,e)},fo=(n,e,t)=>{n.lineTo(e,t)},po=(n,e,t)=>{n.lineTo(t,e)},Hl=gg(0),cd=gg(1),_g=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},xg=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},yg=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},vg=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function Sg(n){return(e,t,i,s,r)=>Er(e,t,(o,a,l,c,h,d,u,m,g,x,f)=>{let{pxRound:p,points:M}=o,P,y;c.ori==0?(P=Vl,y=_g):(P=Gl,y=xg);let A=Vt(M.width*At,3),b=(M.size-M.width)/2*At,_=Vt(b*2,3),v=new Path2D,D=new Path2D,{left:C,top:E,width:L,height:F}=e.bbox;Hl(D,C-_,E-_,L+_*2,F+_*2);let I=O=>{if(l[O]!=null){let V=p(d(a[O],c,x,m)),k=p(u(l[O],h,f,g));P(v,V+b,k),y(v,V,k,b,0,Ll*2)}};if(r)r.forEach(I);else for(let O=i;O<=s;O++)I(O);return{stroke:A>0?v:null,fill:v,clip:D,flags:ho|Yu}})}function Mg(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var Cv=Mg(fo),Pv=Mg(po);function bg(n){let e=wt(n?.alignGaps,0);return(t,i,s,r)=>Er(t,i,(o,a,l,c,h,d,u,m,g,x,f)=>{[s,r]=Fl(l,s,r);let p=o.pxRound,M=F=>p(d(F,c,x,m)),P=F=>p(u(F,h,f,g)),y,A;c.ori==0?(y=fo,A=Cv):(y=po,A=Pv);let b=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ho},v=_.stroke,D=!1;if(r-s>=x*4){let F=ce=>t.posToVal(ce,c.key,!0),I=null,O=null,V,k,K,Y=M(a[b==1?s:r]),Z=M(a[s]),te=M(a[r]),le=F(b==1?Z+1:te-1);for(let ce=b==1?s:r;ce>=s&&ce<=r;ce+=b){let ee=a[ce],_e=(b==1?ee<le:ee>le)?Y:M(ee),oe=l[ce];_e==Y?oe!=null?(k=oe,I==null?(y(v,_e,P(k)),V=I=O=k):k<I?I=k:k>O&&(O=k)):oe===null&&(D=!0):(I!=null&&A(v,Y,P(I),P(O),P(V),P(k)),oe!=null?(k=oe,y(v,_e,P(k)),I=O=V=k):(I=O=null,oe===null&&(D=!0)),Y=_e,le=F(Y+b))}I!=null&&I!=O&&K!=Y&&A(v,Y,P(I),P(O),P(V),P(k))}else for(let F=b==1?s:r;F>=s&&F<=r;F+=b){let I=l[F];I===null?D=!0:I!=null&&y(v,M(a[F]),P(I))}let[E,L]=ad(t,i);if(o.fill!=null||E!=0){let F=_.fill=new Path2D(v),I=o.fillTo(t,i,o.min,o.max,E),O=P(I),V=M(a[s]),k=M(a[r]);b==-1&&([k,V]=[V,k]),y(F,k,O),y(F,V,O)}if(!o.spanGaps){let F=[];D&&F.push(...ld(a,l,s,r,b,M,e)),_.gaps=F=o.gaps(t,i,s,r,F),_.clip=zl(F,c.ori,m,g,x,f)}return L!=0&&(_.band=L==2?[ys(t,i,s,r,v,-1),ys(t,i,s,r,v,1)]:ys(t,i,s,r,v,L)),_})}function Iv(n){let e=wt(n.align,1),t=wt(n.ascDesc,!1),i=wt(n.alignGaps,0),s=wt(n.extend,!1);return(r,o,a,l)=>Er(r,o,(c,h,d,u,m,g,x,f,p,M,P)=>{[a,l]=Fl(d,a,l);let y=c.pxRound,{left:A,width:b}=r.bbox,_=Z=>y(g(Z,u,M,f)),v=Z=>y(x(Z,m,P,p)),D=u.ori==0?fo:po,C={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ho},E=C.stroke,L=u.dir*(u.ori==0?1:-1),F=v(d[L==1?a:l]),I=_(h[L==1?a:l]),O=I,V=I;s&&e==-1&&(V=A,D(E,V,F)),D(E,I,F);for(let Z=L==1?a:l;Z>=a&&Z<=l;Z+=L){let te=d[Z];if(te==null)continue;let le=_(h[Z]),ce=v(te);e==1?D(E,le,F):D(E,O,ce),D(E,le,ce),F=ce,O=le}let k=O;s&&e==1&&(k=A+b,D(E,k,F));let[K,Y]=ad(r,o);if(c.fill!=null||K!=0){let Z=C.fill=new Path2D(E),te=c.fillTo(r,o,c.min,c.max,K),le=v(te);D(Z,k,le),D(Z,V,le)}if(!c.spanGaps){let Z=[];Z.push(...ld(h,d,a,l,L,_,i));let te=c.width*At/2,le=t||e==1?te:-te,ce=t||e==-1?-te:te;Z.forEach(ee=>{ee[0]+=le,ee[1]+=ce}),C.gaps=Z=c.gaps(r,o,a,l,Z),C.clip=zl(Z,u.ori,f,p,M,P)}return Y!=0&&(C.band=Y==2?[ys(r,o,a,l,E,-1),ys(r,o,a,l,E,1)]:ys(r,o,a,l,E,Y)),C})}function Om(n,e,t,i,s,r,o=zt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let h=vn(n[l]-n[a]);h<c&&(c=h,o=vn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function Lv(n){n=n||fa;let e=wt(n.size,[.6,zt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=yt(s),o=1-e[0],a=wt(e[1],zt),l=wt(e[2],1),c=wt(n.disp,fa),h=wt(n.each,m=>{}),{fill:d,stroke:u}=c;return(m,g,x,f)=>Er(m,g,(p,M,P,y,A,b,_,v,D,C,E)=>{let L=p.pxRound,F=t,I=i*At,O=a*At,V=l*At,k,K;y.ori==0?[k,K]=r(m,g):[K,k]=r(m,g);let Y=y.dir*(y.ori==0?1:-1),Z=y.ori==0?Hl:cd,te=y.ori==0?h:(Pe,Je,lt,Ee,kt,We,Ze)=>{h(Pe,Je,lt,kt,Ee,Ze,We)},le=wt(m.bands,nd).find(Pe=>Pe.series[0]==g),ce=le!=null?le.dir:0,ee=p.fillTo(m,g,p.min,p.max,ce),me=L(_(ee,A,E,D)),_e,oe,de,Ne=C,$e=L(p.width*At),Be=!1,st=null,at=null,Xe=null,St=null;d!=null&&($e==0||u!=null)&&(Be=!0,st=d.values(m,g,x,f),at=new Map,new Set(st).forEach(Pe=>{Pe!=null&&at.set(Pe,new Path2D)}),$e>0&&(Xe=u.values(m,g,x,f),St=new Map,new Set(Xe).forEach(Pe=>{Pe!=null&&St.set(Pe,new Path2D)})));let{x0:Ct,size:Kt}=c;if(Ct!=null&&Kt!=null){F=1,M=Ct.values(m,g,x,f),Ct.unit==2&&(M=M.map(lt=>m.posToVal(v+lt*C,y.key,!0)));let Pe=Kt.values(m,g,x,f);Kt.unit==2?oe=Pe[0]*C:oe=b(Pe[0],y,C,v)-b(0,y,C,v),Ne=Om(M,P,b,y,C,v,Ne),de=Ne-oe+I}else Ne=Om(M,P,b,y,C,v,Ne),de=Ne*o+I,oe=Ne-de;de<1&&(de=0),$e>=oe/2&&($e=0),de<5&&(L=qm);let Et=de>0,wn=Ne-de-(Et?$e:0);oe=L(Wu(wn,V,O)),_e=(F==0?oe/2:F==Y?0:oe)-F*Y*((F==0?I/2:0)+(Et?$e/2:0));let Mt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},_n=Be?null:new Path2D,Qt=null;if(le!=null)Qt=m.data[le.series[1]];else{let{y0:Pe,y1:Je}=c;Pe!=null&&Je!=null&&(P=Je.values(m,g,x,f),Qt=Pe.values(m,g,x,f))}let an=k*oe,H=K*oe;for(let Pe=Y==1?x:f;Pe>=x&&Pe<=f;Pe+=Y){let Je=P[Pe];if(Je==null)continue;if(Qt!=null){let $=Qt[Pe]??0;if(Je-$==0)continue;me=_($,A,E,D)}let lt=y.distr!=2||c!=null?M[Pe]:Pe,Ee=b(lt,y,C,v),kt=_(wt(Je,ee),A,E,D),We=L(Ee-_e),Ze=L(Yn(kt,me)),N=L(Ni(kt,me)),w=Ze-N;if(Je!=null){let $=Je<0?H:an,pe=Je<0?an:H;Be?($e>0&&Xe[Pe]!=null&&Z(St.get(Xe[Pe]),We,N+di($e/2),oe,Yn(0,w-$e),$,pe),st[Pe]!=null&&Z(at.get(st[Pe]),We,N+di($e/2),oe,Yn(0,w-$e),$,pe)):Z(_n,We,N+di($e/2),oe,Yn(0,w-$e),$,pe),te(m,g,Pe,We-$e/2,N,oe+$e,w)}}return $e>0?Mt.stroke=Be?St:_n:Be||(Mt._fill=p.width==0?p._fill:p._stroke??p._fill,Mt.width=0),Mt.fill=Be?at:_n,Mt})}function Dv(n,e){let t=wt(e?.alignGaps,0);return(i,s,r,o)=>Er(i,s,(a,l,c,h,d,u,m,g,x,f,p)=>{[r,o]=Fl(c,r,o);let M=a.pxRound,P=k=>M(u(k,h,f,g)),y=k=>M(m(k,d,p,x)),A,b,_;h.ori==0?(A=Vl,_=fo,b=yg):(A=Gl,_=po,b=vg);let v=h.dir*(h.ori==0?1:-1),D=P(l[v==1?r:o]),C=D,E=[],L=[];for(let k=v==1?r:o;k>=r&&k<=o;k+=v)if(c[k]!=null){let Y=l[k],Z=P(Y);E.push(C=Z),L.push(y(c[k]))}let F={stroke:n(E,L,A,_,b,M),fill:null,clip:null,band:null,gaps:null,flags:ho},I=F.stroke,[O,V]=ad(i,s);if(a.fill!=null||O!=0){let k=F.fill=new Path2D(I),K=a.fillTo(i,s,a.min,a.max,O),Y=y(K);_(k,C,Y),_(k,D,Y)}if(!a.spanGaps){let k=[];k.push(...ld(l,c,r,o,v,P,t)),F.gaps=k=a.gaps(i,s,r,o,k),F.clip=zl(k,h.ori,g,x,f,p)}return V!=0&&(F.band=V==2?[ys(i,s,r,o,I,-1),ys(i,s,r,o,I,1)]:ys(i,s,r,o,I,V)),F})}function Nv(n){return Dv(Uv,n)}function Uv(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),d=Array(o-1);for(let u=0;u<o-1;u++)h[u]=e[u+1]-e[u],d[u]=n[u+1]-n[u],c[u]=h[u]/d[u];l[0]=c[0];for(let u=1;u<o-1;u++)c[u]===0||c[u-1]===0||c[u-1]>0!=c[u]>0?l[u]=0:(l[u]=3*(d[u-1]+d[u])/((2*d[u]+d[u-1])/c[u-1]+(d[u]+2*d[u-1])/c[u]),isFinite(l[u])||(l[u]=0));l[o-1]=c[o-2];for(let u=0;u<o-1;u++)s(a,n[u]+d[u]/3,e[u]+l[u]*d[u]/3,n[u+1]-d[u]/3,e[u+1]-l[u+1]*d[u]/3,n[u+1],e[u+1])}return a}var $u=new Set;function Bm(){for(let n of $u)n.syncRect(!0)}uo&&(br(my,oo,Bm),br(gy,oo,Bm,!0),br(Dl,oo,()=>{In.pxRatio=At}));var Fv=bg(),Ov=Sg();function km(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Zu(r,o,e,t))}function Bv(n,e){return n.map((t,i)=>i==0?{}:pn({},e,t))}function Zu(n,e,t,i){return pn({},e==0?t:i,n)}function wg(n,e,t){return e==null?lo:[e,t]}var kv=wg;function zv(n,e,t){return e==null?lo:Nl(e,t,ed,!0)}function Eg(n,e,t,i){return e==null?lo:Ol(e,t,n.scales[i].log,!1)}var Vv=Eg;function Tg(n,e,t,i){return e==null?lo:Qu(e,t,n.scales[i].log,!1)}var Gv=Tg;function Hv(n,e,t,i,s){let r=Yn(_m(n),_m(e)),o=e-n,a=Di(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?Hs.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function zm(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=yn((t=+s)*At))+"px"),[n,e,t]}function Wv(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Vt(e[2]*At,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function In(n,e,t){let i={mode:wt(n.mode,1)},s=i.mode;function r(S,T,U,B){let q=T.valToPct(S);return B+U*(T.dir==-1?1-q:q)}function o(S,T,U,B){let q=T.valToPct(S);return B+U*(T.dir==-1?q:1-q)}function a(S,T,U,B){return T.ori==0?r(S,T,U,B):o(S,T,U,B)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Mi(Jx);if(n.id!=null&&(c.id=n.id),ui(c,n.class),n.title){let S=Mi(ey,c);S.textContent=n.title}let h=Li("canvas"),d=i.ctx=h.getContext("2d"),u=Mi(ty,c);br("click",u,S=>{S.target===g&&(Xt!=$r||jt!=Zr)&&Pn.click(i,S)},!0);let m=i.under=Mi(ny,u);u.appendChild(h);let g=i.over=Mi(iy,u);n=co(n);let x=+wt(n.pxAlign,1),f=Fm(x);(n.plugins||[]).forEach(S=>{S.opts&&(n=S.opts(i,n)||n)});let p=n.ms||.001,M=i.series=s==1?km(n.series||[],Cm,Nm,!1):Bv(n.series||[null],Dm),P=i.axes=km(n.axes||[],Rm,Im,!0),y=i.scales={},A=i.bands=n.bands||[];A.forEach(S=>{S.fill=yt(S.fill||null),S.dir=wt(S.dir,-1)});let b=s==2?M[1].facets[0].scale:M[0].scale,_={axes:gs,series:gt},v=(n.drawOrder||["axes","series"]).map(S=>_[S]);function D(S){let T=S.distr==3?U=>xs(U>0?U:S.clamp(i,U,S.min,S.max,S.key)):S.distr==4?U=>Fu(U,S.asinh):S.distr==100?U=>S.fwd(U):U=>U;return U=>{let B=T(U),{_min:q,_max:Q}=S,ue=Q-q;return(B-q)/ue}}function C(S){let T=y[S];if(T==null){let U=(n.scales||fa)[S]||fa;if(U.from!=null){C(U.from);let B=pn({},y[U.from],U,{key:S});B.valToPct=D(B),y[S]=B}else{T=y[S]=pn({},S==b?pg:Tv,U),T.key=S;let B=T.time,q=T.range,Q=Gs(q);if((S!=b||s==2&&!B)&&(Q&&(q[0]==null||q[1]==null)&&(q={min:q[0]==null?pm:{mode:1,hard:q[0],soft:q[0]},max:q[1]==null?pm:{mode:1,hard:q[1],soft:q[1]}},Q=!1),!Q&&kl(q))){let ue=q;q=(ge,Me,Ue)=>Me==null?lo:Nl(Me,Ue,ue)}T.range=yt(q||(B?kv:S==b?T.distr==3?Vv:T.distr==4?Gv:wg:T.distr==3?Eg:T.distr==4?Tg:zv)),T.auto=yt(Q?!1:T.auto),T.clamp=yt(T.clamp||Ev),T._min=T._max=null,T.valToPct=D(T)}}}C("x"),C("y"),s==1&&M.forEach(S=>{C(S.scale)}),P.forEach(S=>{C(S.scale)});for(let S in n.scales)C(S);let E=y[b],L=E.distr,F,I;E.ori==0?(ui(c,Kx),F=r,I=o):(ui(c,Qx),F=o,I=r);let O={};for(let S in y){let T=y[S];(T.min!=null||T.max!=null)&&(O[S]={min:T.min,max:T.max},T.min=T.max=null)}let V=n.tzDate||(S=>new Date(yn(S/p))),k=n.fmtDate||id,K=p==1?Ky(V):tv(V),Y=Em(V,wm(p==1?Jy:ev,k)),Z=Am(V,Tm(iv,k)),te=[],le=i.legend=pn({},ov,n.legend),ce=i.cursor=pn({},dv,{drag:{y:s==2}},n.cursor),ee=le.show,me=ce.show,_e=le.markers;le.idxs=te,_e.width=yt(_e.width),_e.dash=yt(_e.dash),_e.stroke=yt(_e.stroke),_e.fill=yt(_e.fill);let oe,de,Ne,$e=[],Be=[],st,at=!1,Xe={};if(le.live){let S=M[1]?M[1].values:null;at=S!=null,st=at?S(i,1,0):{_:0};for(let T in st)Xe[T]=Ju}if(ee)if(oe=Li("table",cy,c),Ne=Li("tbody",null,oe),le.mount(i,oe),at){de=Li("thead",null,oe,Ne);let S=Li("tr",null,de);Li("th",null,S);for(var St in st)Li("th",tm,S).textContent=St}else ui(oe,uy),le.live&&ui(oe,hy);let Ct={show:!0},Kt={show:!1};function Et(S,T){if(T==0&&(at||!le.live||s==2))return lo;let U=[],B=Li("tr",dy,Ne,Ne.childNodes[T]);ui(B,S.class),S.show||ui(B,Mr);let q=Li("th",null,B);if(_e.show){let ge=Mi(fy,q);if(T>0){let Me=_e.width(i,T);Me&&(ge.style.border=Me+"px "+_e.dash(i,T)+" "+_e.stroke(i,T)),ge.style.background=_e.fill(i,T)}}let Q=Mi(tm,q);S.label instanceof HTMLElement?Q.appendChild(S.label):Q.textContent=S.label,T>0&&(_e.show||(Q.style.color=S.width>0?_e.stroke(i,T):_e.fill(i,T)),Mt("click",q,ge=>{if(ce._lock)return;et(ge);let Me=M.indexOf(S);if((ge.ctrlKey||ge.metaKey)!=le.isolate){let Ue=M.some((Fe,ze)=>ze>0&&ze!=Me&&Fe.show);M.forEach((Fe,ze)=>{ze>0&&Zi(ze,Ue?ze==Me?Ct:Kt:Ct,!0,un.setSeries)})}else Zi(Me,{show:!S.show},!0,un.setSeries)},!1),tt&&Mt(rm,q,ge=>{ce._lock||(et(ge),Zi(M.indexOf(S),Jr,!0,un.setSeries))},!1));for(var ue in st){let ge=Li("td",py,B);ge.textContent="--",U.push(ge)}return[B,U]}let wn=new Map;function Mt(S,T,U,B=!0){let q=wn.get(T)||{},Q=ce.bind[S](i,T,U,B);Q&&(br(S,T,q[S]=Q),wn.set(T,q))}function _n(S,T,U){let B=wn.get(T)||{};for(let q in B)(S==null||q==S)&&(Hu(q,T,B[q]),delete B[q]);S==null&&wn.delete(T)}let Qt=0,an=0,H=0,Pe=0,Je=0,lt=0,Ee=Je,kt=lt,We=H,Ze=Pe,N=0,w=0,$=0,pe=0;i.bbox={};let he=!1,ve=!1,Se=!1,ie=!1,re=!1,xe=!1;function G(S,T,U){(U||S!=i.width||T!=i.height)&&ae(S,T),dt(!1),Se=!0,ve=!0,Fn()}function ae(S,T){i.width=Qt=H=S,i.height=an=Pe=T,Je=lt=0,we(),qe();let U=i.bbox;N=U.left=vr(Je*At,.5),w=U.top=vr(lt*At,.5),$=U.width=vr(H*At,.5),pe=U.height=vr(Pe*At,.5)}let se=3;function Te(){let S=!1,T=0;for(;!S;){T++;let U=Xr(T),B=$i(T);S=T==se||U&&B,S||(ae(i.width,i.height),ve=!0)}}function ye({width:S,height:T}){G(S,T)}i.setSize=ye;function we(){let S=!1,T=!1,U=!1,B=!1;P.forEach((q,Q)=>{if(q.show&&q._show){let{side:ue,_size:ge}=q,Me=ue%2,Ue=q.label!=null?q.labelSize:0,Fe=ge+Ue;Fe>0&&(Me?(H-=Fe,ue==3?(Je+=Fe,B=!0):U=!0):(Pe-=Fe,ue==0?(lt+=Fe,S=!0):T=!0))}}),qi[0]=S,qi[1]=U,qi[2]=T,qi[3]=B,H-=Ai[1]+Ai[3],Je+=Ai[3],Pe-=Ai[2]+Ai[0],lt+=Ai[0]}function qe(){let S=Je+H,T=lt+Pe,U=Je,B=lt;function q(Q,ue){switch(Q){case 1:return S+=ue,S-ue;case 2:return T+=ue,T-ue;case 3:return U-=ue,U+ue;case 0:return B-=ue,B+ue}}P.forEach((Q,ue)=>{if(Q.show&&Q._show){let ge=Q.side;Q._pos=q(ge,Q._size),Q.label!=null&&(Q._lpos=q(ge,Q.labelSize))}})}if(ce.dataIdx==null){let S=ce.hover,T=S.skip=new Set(S.skip??[]);T.add(void 0);let U=S.prox=yt(S.prox),B=S.bias??=0;ce.dataIdx=(q,Q,ue,ge)=>{if(Q==0)return ue;let Me=ue,Ue=U(q,Q,ue,ge)??zt,Fe=Ue>=0&&Ue<zt,ze=E.ori==0?H:Pe,ot=ce.left,Tt=e[0],bt=e[Q];if(T.has(bt[ue])){Me=null;let _t=null,Qe=null,Ye;if(B==0||B==-1)for(Ye=ue;_t==null&&Ye-- >0;)T.has(bt[Ye])||(_t=Ye);if(B==0||B==1)for(Ye=ue;Qe==null&&Ye++<bt.length;)T.has(bt[Ye])||(Qe=Ye);if(_t!=null||Qe!=null)if(Fe){let Yt=_t==null?-1/0:F(Tt[_t],E,ze,0),nn=Qe==null?1/0:F(Tt[Qe],E,ze,0),Rn=ot-Yt,Bt=nn-ot;Rn<=Bt?Rn<=Ue&&(Me=_t):Bt<=Ue&&(Me=Qe)}else Me=Qe==null?_t:_t==null?Qe:ue-_t<=Qe-ue?_t:Qe}else Fe&&vn(ot-F(Tt[ue],E,ze,0))>Ue&&(Me=null);return Me}}let et=S=>{ce.event=S};ce.idxs=te,ce._lock=!1;let fe=ce.points;fe.show=yt(fe.show),fe.size=yt(fe.size),fe.stroke=yt(fe.stroke),fe.width=yt(fe.width),fe.fill=yt(fe.fill);let Ve=i.focus=pn({},n.focus||{alpha:.3},ce.focus),tt=Ve.prox>=0,Ce=tt&&fe.one,ut=[],Wt=[],Gn=[];function Zo(S,T){let U=fe.show(i,T);if(U instanceof HTMLElement)return ui(U,ly),ui(U,S.class),ns(U,-10,-10,H,Pe),g.insertBefore(U,ut[T]),U}function Gr(S,T){if(s==1||T>0){let U=s==1&&y[S.scale].time,B=S.value;S.value=U?vm(B)?Am(V,Tm(B,k)):B||Z:B||Mv,S.label=S.label||(U?pv:fv)}if(Ce||T>0){S.width=S.width==null?1:S.width,S.paths=S.paths||Fv||Ty,S.fillTo=yt(S.fillTo||Av),S.pxAlign=+wt(S.pxAlign,x),S.pxRound=Fm(S.pxAlign),S.stroke=yt(S.stroke||null),S.fill=yt(S.fill||null),S._stroke=S._fill=S._paths=S._focus=null;let U=bv(Yn(1,S.width),1),B=S.points=pn({},{size:U,width:Yn(1,U*.2),stroke:S.stroke,space:U*2,paths:Ov,_stroke:null,_fill:null},S.points);B.show=yt(B.show),B.filter=yt(B.filter),B.fill=yt(B.fill),B.stroke=yt(B.stroke),B.paths=yt(B.paths),B.pxAlign=S.pxAlign}if(ee){let U=Et(S,T);$e.splice(T,0,U[0]),Be.splice(T,0,U[1]),le.values.push(null)}if(me){te.splice(T,0,null);let U=null;Ce?T==0&&(U=Zo(S,T)):T>0&&(U=Zo(S,T)),ut.splice(T,0,U),Wt.splice(T,0,0),Gn.splice(T,0,0)}An("addSeries",T)}function nu(S,T){T=T??M.length,S=s==1?Zu(S,T,Cm,Nm):Zu(S,T,{},Dm),M.splice(T,0,S),Gr(M[T],T)}i.addSeries=nu;function pl(S){if(M.splice(S,1),ee){le.values.splice(S,1),Be.splice(S,1);let T=$e.splice(S,1)[0];_n(null,T.firstChild),T.remove()}me&&(te.splice(S,1),ut.splice(S,1)[0].remove(),Wt.splice(S,1),Gn.splice(S,1)),An("delSeries",S)}i.delSeries=pl;let qi=[!1,!1,!1,!1];function fs(S,T){if(S._show=S.show,S.show){let U=S.side%2,B=y[S.scale];B==null&&(S.scale=U?M[1].scale:b,B=y[S.scale]);let q=B.time;S.size=yt(S.size),S.space=yt(S.space),S.rotate=yt(S.rotate),Gs(S.incrs)&&S.incrs.forEach(ue=>{!Hs.has(ue)&&Hs.set(ue,Zm(ue))}),S.incrs=yt(S.incrs||(B.distr==2?$y:q?p==1?jy:Qy:Sr)),S.splits=yt(S.splits||(q&&B.distr==1?K:B.distr==3?Xu:B.distr==4?_v:gv)),S.stroke=yt(S.stroke),S.grid.stroke=yt(S.grid.stroke),S.ticks.stroke=yt(S.ticks.stroke),S.border.stroke=yt(S.border.stroke);let Q=S.values;S.values=Gs(Q)&&!Gs(Q[0])?yt(Q):q?Gs(Q)?Em(V,wm(Q,k)):vm(Q)?nv(V,Q):Q||Y:Q||mv,S.filter=yt(S.filter||(B.distr>=3&&B.log==10?vv:B.distr==3&&B.log==2?Sv:Ym)),S.font=zm(S.font),S.labelFont=zm(S.labelFont),S._size=S.size(i,null,T,0),S._space=S._rotate=S._incrs=S._found=S._splits=S._values=null,S._size>0&&(qi[T]=!0,S._el=Mi(sy,u))}}function ps(S,T,U,B){let[q,Q,ue,ge]=U,Me=T%2,Ue=0;return Me==0&&(ge||Q)&&(Ue=T==0&&!q||T==2&&!ue?yn(Rm.size/3):0),Me==1&&(q||ue)&&(Ue=T==1&&!Q||T==3&&!ge?yn(Im.size/2):0),Ue}let jo=i.padding=(n.padding||[ps,ps,ps,ps]).map(S=>yt(wt(S,ps))),Ai=i._padding=jo.map((S,T)=>S(i,T,qi,0)),en,rn=null,on=null,Yi=s==1?M[0].idxs:null,oi=null,Ds=!1;function Jo(S,T){if(e=S??[],i.data=i._data=e,s==2){en=0;for(let U=1;U<M.length;U++)en+=e[U][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),oi=e[0],en=oi.length;let U=e;if(L==2){U=e.slice();let B=U[0]=Array(en);for(let q=0;q<en;q++)B[q]=q}i._data=e=U}if(dt(!0),An("setData"),L==2&&(Se=!0),T!==!1){let U=E;U.auto(i,Ds)?Ko():Fs(b,U.min,U.max),ie=ie||ce.left>=0,xe=!0,Fn()}}i.setData=Jo;function Ko(){Ds=!0;let S,T;s==1&&(en>0?(rn=Yi[0]=0,on=Yi[1]=en-1,S=e[0][rn],T=e[0][on],L==2?(S=rn,T=on):S==T&&(L==3?[S,T]=Ol(S,S,E.log,!1):L==4?[S,T]=Qu(S,S,E.log,!1):E.time?T=S+yn(86400/p):[S,T]=Nl(S,T,ed,!0))):(rn=Yi[0]=S=null,on=Yi[1]=T=null)),Fs(b,S,T)}let Hr,Ns,Wr,R,W,ne,j,J,Ae,Le;function Re(S,T,U,B,q,Q){S??=im,U??=nd,B??="butt",q??=im,Q??="round",S!=Hr&&(d.strokeStyle=Hr=S),q!=Ns&&(d.fillStyle=Ns=q),T!=Wr&&(d.lineWidth=Wr=T),Q!=W&&(d.lineJoin=W=Q),B!=ne&&(d.lineCap=ne=B),U!=R&&d.setLineDash(R=U)}function De(S,T,U,B){T!=Ns&&(d.fillStyle=Ns=T),S!=j&&(d.font=j=S),U!=J&&(d.textAlign=J=U),B!=Ae&&(d.textBaseline=Ae=B)}function He(S,T,U,B,q=0){if(B.length>0&&S.auto(i,Ds)&&(T==null||T.min==null)){let Q=wt(rn,0),ue=wt(on,B.length-1),ge=U.min==null?vy(B,Q,ue,q,S.distr==3):[U.min,U.max];S.min=Ni(S.min,U.min=ge[0]),S.max=Yn(S.max,U.max=ge[1])}}let nt={min:null,max:null};function mt(){for(let B in y){let q=y[B];O[B]==null&&(q.min==null||O[b]!=null&&q.auto(i,Ds))&&(O[B]=nt)}for(let B in y){let q=y[B];O[B]==null&&q.from!=null&&O[q.from]!=null&&(O[B]=nt)}O[b]!=null&&dt(!0);let S={};for(let B in O){let q=O[B];if(q!=null){let Q=S[B]=co(y[B],Cy);if(q.min!=null)pn(Q,q);else if(B!=b||s==2)if(en==0&&Q.from==null){let ue=Q.range(i,null,null,B);Q.min=ue[0],Q.max=ue[1]}else Q.min=zt,Q.max=-zt}}if(en>0){M.forEach((B,q)=>{if(s==1){let Q=B.scale,ue=O[Q];if(ue==null)return;let ge=S[Q];if(q==0){let Me=ge.range(i,ge.min,ge.max,Q);ge.min=Me[0],ge.max=Me[1],rn=Di(ge.min,e[0]),on=Di(ge.max,e[0]),on-rn>1&&(e[0][rn]<ge.min&&rn++,e[0][on]>ge.max&&on--),B.min=oi[rn],B.max=oi[on]}else B.show&&B.auto&&He(ge,ue,B,e[q],B.sorted);B.idxs[0]=rn,B.idxs[1]=on}else if(q>0&&B.show&&B.auto){let[Q,ue]=B.facets,ge=Q.scale,Me=ue.scale,[Ue,Fe]=e[q],ze=S[ge],ot=S[Me];ze!=null&&He(ze,O[ge],Q,Ue,Q.sorted),ot!=null&&He(ot,O[Me],ue,Fe,ue.sorted),B.min=ue.min,B.max=ue.max}});for(let B in S){let q=S[B],Q=O[B];if(q.from==null&&(Q==null||Q.min==null)){let ue=q.range(i,q.min==zt?null:q.min,q.max==-zt?null:q.max,B);q.min=ue[0],q.max=ue[1]}}}for(let B in S){let q=S[B];if(q.from!=null){let Q=S[q.from];if(Q.min==null)q.min=q.max=null;else{let ue=q.range(i,Q.min,Q.max,B);q.min=ue[0],q.max=ue[1]}}}let T={},U=!1;for(let B in S){let q=S[B],Q=y[B];if(Q.min!=q.min||Q.max!=q.max){Q.min=q.min,Q.max=q.max;let ue=Q.distr;Q._min=ue==3?xs(Q.min):ue==4?Fu(Q.min,Q.asinh):ue==100?Q.fwd(Q.min):Q.min,Q._max=ue==3?xs(Q.max):ue==4?Fu(Q.max,Q.asinh):ue==100?Q.fwd(Q.max):Q.max,T[B]=U=!0}}if(U){M.forEach((B,q)=>{s==2?q>0&&T.y&&(B._paths=null):T[B.scale]&&(B._paths=null)});for(let B in T)Se=!0,An("setScale",B);me&&ce.left>=0&&(ie=xe=!0)}for(let B in O)O[B]=null}function Ge(S){let T=Wu(rn-1,0,en-1),U=Wu(on+1,0,en-1);for(;S[T]==null&&T>0;)T--;for(;S[U]==null&&U<en-1;)U++;return[T,U]}function gt(){if(en>0){let S=M.some(T=>T._focus)&&Le!=Ve.alpha;S&&(d.globalAlpha=Le=Ve.alpha),M.forEach((T,U)=>{if(U>0&&T.show&&(Jt(U,!1),Jt(U,!0),T._paths==null)){let B=Le;Le!=T.alpha&&(d.globalAlpha=Le=T.alpha);let q=s==2?[0,e[U][0].length-1]:Ge(e[U]);T._paths=T.paths(i,U,q[0],q[1]),Le!=B&&(d.globalAlpha=Le=B)}}),M.forEach((T,U)=>{if(U>0&&T.show){let B=Le;Le!=T.alpha&&(d.globalAlpha=Le=T.alpha),T._paths!=null&&Nt(U,!1);{let q=T._paths!=null?T._paths.gaps:null,Q=T.points.show(i,U,rn,on,q),ue=T.points.filter(i,U,Q,q);(Q||ue)&&(T.points._paths=T.points.paths(i,U,rn,on,ue),Nt(U,!0))}Le!=B&&(d.globalAlpha=Le=B),An("drawSeries",U)}}),S&&(d.globalAlpha=Le=1)}}function Jt(S,T){let U=T?M[S].points:M[S];U._stroke=U.stroke(i,S),U._fill=U.fill(i,S)}function Nt(S,T){let U=T?M[S].points:M[S],{stroke:B,fill:q,clip:Q,flags:ue,_stroke:ge=U._stroke,_fill:Me=U._fill,_width:Ue=U.width}=U._paths;Ue=Vt(Ue*At,3);let Fe=null,ze=Ue%2/2;T&&Me==null&&(Me=Ue>0?"#fff":ge);let ot=U.pxAlign==1&&ze>0;if(ot&&d.translate(ze,ze),!T){let Tt=N-Ue/2,bt=w-Ue/2,_t=$+Ue,Qe=pe+Ue;Fe=new Path2D,Fe.rect(Tt,bt,_t,Qe)}T?ke(ge,Ue,U.dash,U.cap,Me,B,q,ue,Q):Ut(S,ge,Ue,U.dash,U.cap,Me,B,q,ue,Fe,Q),ot&&d.translate(-ze,-ze)}function Ut(S,T,U,B,q,Q,ue,ge,Me,Ue,Fe){let ze=!1;Me!=0&&A.forEach((ot,Tt)=>{if(ot.series[0]==S){let bt=M[ot.series[1]],_t=e[ot.series[1]],Qe=(bt._paths||fa).band;Gs(Qe)&&(Qe=ot.dir==1?Qe[0]:Qe[1]);let Ye,Yt=null;bt.show&&Qe&&My(_t,rn,on)?(Yt=ot.fill(i,Tt)||Q,Ye=bt._paths.clip):Qe=null,ke(T,U,B,q,Yt,ue,ge,Me,Ue,Fe,Ye,Qe),ze=!0}}),ze||ke(T,U,B,q,Q,ue,ge,Me,Ue,Fe)}let xn=ho|Yu;function ke(S,T,U,B,q,Q,ue,ge,Me,Ue,Fe,ze){Re(S,T,U,B,q),(Me||Ue||ze)&&(d.save(),Me&&d.clip(Me),Ue&&d.clip(Ue)),ze?(ge&xn)==xn?(d.clip(ze),Fe&&d.clip(Fe),xt(q,ue),ln(S,Q,T)):ge&Yu?(xt(q,ue),d.clip(ze),ln(S,Q,T)):ge&ho&&(d.save(),d.clip(ze),Fe&&d.clip(Fe),xt(q,ue),d.restore(),ln(S,Q,T)):(xt(q,ue),ln(S,Q,T)),(Me||Ue||ze)&&d.restore()}function ln(S,T,U){U>0&&(T instanceof Map?T.forEach((B,q)=>{d.strokeStyle=Hr=q,d.stroke(B)}):T!=null&&S&&d.stroke(T))}function xt(S,T){T instanceof Map?T.forEach((U,B)=>{d.fillStyle=Ns=B,d.fill(U)}):T!=null&&S&&d.fill(T)}function ms(S,T,U,B){let q=P[S],Q;if(B<=0)Q=[0,0];else{let ue=q._space=q.space(i,S,T,U,B),ge=q._incrs=q.incrs(i,S,T,U,B,ue);Q=Hv(T,U,ge,B,ue)}return q._found=Q}function cn(S,T,U,B,q,Q,ue,ge,Me,Ue){let Fe=ue%2/2;x==1&&d.translate(Fe,Fe),Re(ge,ue,Me,Ue,ge),d.beginPath();let ze,ot,Tt,bt,_t=q+(B==0||B==3?-Q:Q);U==0?(ot=q,bt=_t):(ze=q,Tt=_t);for(let Qe=0;Qe<S.length;Qe++)T[Qe]!=null&&(U==0?ze=Tt=S[Qe]:ot=bt=S[Qe],d.moveTo(ze,ot),d.lineTo(Tt,bt));d.stroke(),x==1&&d.translate(-Fe,-Fe)}function Xr(S){let T=!0;return P.forEach((U,B)=>{if(!U.show)return;let q=y[U.scale];if(q.min==null){U._show&&(T=!1,U._show=!1,dt(!1));return}else U._show||(T=!1,U._show=!0,dt(!1));let Q=U.side,ue=Q%2,{min:ge,max:Me}=q,[Ue,Fe]=ms(B,ge,Me,ue==0?H:Pe);if(Fe==0)return;let ze=q.distr==2,ot=U._splits=U.splits(i,B,ge,Me,Ue,Fe,ze),Tt=q.distr==2?ot.map(Ye=>oi[Ye]):ot,bt=q.distr==2?oi[ot[1]]-oi[ot[0]]:Ue,_t=U._values=U.values(i,U.filter(i,Tt,B,Fe,bt),B,Fe,bt);U._rotate=Q==2?U.rotate(i,_t,B,Fe):0;let Qe=U._size;U._size=bi(U.size(i,_t,B,S)),Qe!=null&&U._size!=Qe&&(T=!1)}),T}function $i(S){let T=!0;return jo.forEach((U,B)=>{let q=U(i,B,qi,S);q!=Ai[B]&&(T=!1),Ai[B]=q}),T}function gs(){for(let S=0;S<P.length;S++){let T=P[S];if(!T.show||!T._show)continue;let U=T.side,B=U%2,q,Q,ue=T.stroke(i,S),ge=U==0||U==3?-1:1,[Me,Ue]=T._found;if(T.label!=null){let Xn=T.labelGap*ge,ci=yn((T._lpos+Xn)*At);De(T.labelFont[0],ue,"center",U==2?"top":nm),d.save(),B==1?(q=Q=0,d.translate(ci,yn(w+pe/2)),d.rotate((U==3?-Ll:Ll)/2)):(q=yn(N+$/2),Q=ci);let pr=Xm(T.label)?T.label(i,S,Me,Ue):T.label;d.fillText(pr,q,Q),d.restore()}if(Ue==0)continue;let Fe=y[T.scale],ze=B==0?$:pe,ot=B==0?N:w,Tt=T._splits,bt=Fe.distr==2?Tt.map(Xn=>oi[Xn]):Tt,_t=Fe.distr==2?oi[Tt[1]]-oi[Tt[0]]:Me,Qe=T.ticks,Ye=T.border,Yt=Qe.show?Qe.size:0,nn=yn(Yt*At),Rn=yn((T.alignTo==2?T._size-Yt-T.gap:T.gap)*At),Bt=T._rotate*-Ll/180,sn=f(T._pos*At),ai=(nn+Rn)*ge,Wn=sn+ai;Q=B==0?Wn:0,q=B==1?Wn:0;let vi=T.font[0],Ri=T.align==1?so:T.align==2?Du:Bt>0?so:Bt<0?Du:B==0?"center":U==3?Du:so,Ji=Bt||B==1?"middle":U==2?"top":nm;De(vi,ue,Ri,Ji);let li=T.font[1]*T.lineGap,Si=Tt.map(Xn=>f(a(Xn,Fe,ze,ot))),Ci=T._values;for(let Xn=0;Xn<Ci.length;Xn++){let ci=Ci[Xn];if(ci!=null){B==0?q=Si[Xn]:Q=Si[Xn],ci=""+ci;let pr=ci.indexOf(`
`)==-1?[ci]:ci.split(/\n/gm);for(let qn=0;qn<pr.length;qn++){let lp=pr[qn];Bt?(d.save(),d.translate(q,Q+qn*li),d.rotate(Bt),d.fillText(lp,0,0),d.restore()):d.fillText(lp,q,Q+qn*li)}}}Qe.show&&cn(Si,Qe.filter(i,bt,S,Ue,_t),B,U,sn,nn,Vt(Qe.width*At,3),Qe.stroke(i,S),Qe.dash,Qe.cap);let Ki=T.grid;Ki.show&&cn(Si,Ki.filter(i,bt,S,Ue,_t),B,B==0?2:1,B==0?w:N,B==0?pe:$,Vt(Ki.width*At,3),Ki.stroke(i,S),Ki.dash,Ki.cap),Ye.show&&cn([sn],[1],B==0?1:0,B==0?1:2,B==1?w:N,B==1?pe:$,Vt(Ye.width*At,3),Ye.stroke(i,S),Ye.dash,Ye.cap)}An("drawAxes")}function dt(S){M.forEach((T,U)=>{U>0&&(T._paths=null,S&&(s==1?(T.min=null,T.max=null):T.facets.forEach(B=>{B.min=null,B.max=null})))})}let tn=!1,Hn=!1,Ft=[];function hn(){Hn=!1;for(let S=0;S<Ft.length;S++)An(...Ft[S]);Ft.length=0}function Fn(){tn||(Fy(Wf),tn=!0)}function ml(S,T=!1){tn=!0,Hn=T,S(i),Wf(),T&&Ft.length>0&&queueMicrotask(hn)}i.batch=ml;function Wf(){if(he&&(mt(),he=!1),Se&&(Te(),Se=!1),ve){if($t(m,so,Je),$t(m,"top",lt),$t(m,ca,H),$t(m,ha,Pe),$t(g,so,Je),$t(g,"top",lt),$t(g,ca,H),$t(g,ha,Pe),$t(u,ca,Qt),$t(u,ha,an),h.width=yn(Qt*At),h.height=yn(an*At),P.forEach(({_el:S,_show:T,_size:U,_pos:B,side:q})=>{if(S!=null)if(T){let Q=q===3||q===0?U:0,ue=q%2==1;$t(S,ue?"left":"top",B-Q),$t(S,ue?"width":"height",U),$t(S,ue?"top":"left",ue?lt:Je),$t(S,ue?"height":"width",ue?Pe:H),Gu(S,Mr)}else ui(S,Mr)}),Hr=Ns=Wr=W=ne=j=J=Ae=R=null,Le=1,ta(!0),Je!=Ee||lt!=kt||H!=We||Pe!=Ze){dt(!1);let S=H/We,T=Pe/Ze;if(me&&!ie&&ce.left>=0){ce.left*=S,ce.top*=T,qr&&ns(qr,yn(ce.left),0,H,Pe),Yr&&ns(Yr,0,yn(ce.top),H,Pe);for(let U=0;U<ut.length;U++){let B=ut[U];B!=null&&(Wt[U]*=S,Gn[U]*=T,ns(B,bi(Wt[U]),bi(Gn[U]),H,Pe))}}if(qt.show&&!re&&qt.left>=0&&qt.width>0){qt.left*=S,qt.width*=S,qt.top*=T,qt.height*=T;for(let U in lu)$t(jr,U,qt[U])}Ee=Je,kt=lt,We=H,Ze=Pe}An("setSize"),ve=!1}Qt>0&&an>0&&(d.clearRect(0,0,h.width,h.height),An("drawClear"),v.forEach(S=>S()),An("draw")),qt.show&&re&&(gl(qt),re=!1),me&&ie&&(fr(null,!0,!1),ie=!1),le.show&&le.live&&xe&&(ou(),xe=!1),l||(l=!0,i.status=1,An("ready")),Ds=!1,tn=!1}i.redraw=(S,T)=>{Se=T||!1,S!==!1?Fs(b,E.min,E.max):Fn()};function iu(S,T){let U=y[S];if(U.from==null){if(en==0){let B=U.range(i,T.min,T.max,S);T.min=B[0],T.max=B[1]}if(T.min>T.max){let B=T.min;T.min=T.max,T.max=B}if(en>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;S==b&&U.distr==2&&en>0&&(T.min=Di(T.min,e[0]),T.max=Di(T.max,e[0]),T.min==T.max&&T.max++),O[S]=T,he=!0,Fn()}}i.setScale=iu;let su,ru,qr,Yr,Xf,qf,$r,Zr,Yf,$f,Xt,jt,Us=!1,Pn=ce.drag,En=Pn.x,Tn=Pn.y;me&&(ce.x&&(su=Mi(oy,g)),ce.y&&(ru=Mi(ay,g)),E.ori==0?(qr=su,Yr=ru):(qr=ru,Yr=su),Xt=ce.left,jt=ce.top);let qt=i.select=pn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),jr=qt.show?Mi(ry,qt.over?g:m):null;function gl(S,T){if(qt.show){for(let U in S)qt[U]=S[U],U in lu&&$t(jr,U,S[U]);T!==!1&&An("setSelect")}}i.setSelect=gl;function Z_(S){if(M[S].show)ee&&Gu($e[S],Mr);else if(ee&&ui($e[S],Mr),me){let U=Ce?ut[0]:ut[S];U!=null&&ns(U,-10,-10,H,Pe)}}function Fs(S,T,U){iu(S,{min:T,max:U})}function Zi(S,T,U,B){T.focus!=null&&ex(S),T.show!=null&&M.forEach((q,Q)=>{Q>0&&(S==Q||S==null)&&(q.show=T.show,Z_(Q),s==2?(Fs(q.facets[0].scale,null,null),Fs(q.facets[1].scale,null,null)):Fs(q.scale,null,null),Fn())}),U!==!1&&An("setSeries",S,T),B&&na("setSeries",i,S,T)}i.setSeries=Zi;function j_(S,T){pn(A[S],T)}function J_(S,T){S.fill=yt(S.fill||null),S.dir=wt(S.dir,-1),T=T??A.length,A.splice(T,0,S)}function K_(S){S==null?A.length=0:A.splice(S,1)}i.addBand=J_,i.setBand=j_,i.delBand=K_;function Q_(S,T){M[S].alpha=T,me&&ut[S]!=null&&(ut[S].style.opacity=T),ee&&$e[S]&&($e[S].style.opacity=T)}let _s,Os,dr,Jr={focus:!0};function ex(S){if(S!=dr){let T=S==null,U=Ve.alpha!=1;M.forEach((B,q)=>{if(s==1||q>0){let Q=T||q==0||q==S;B._focus=T?null:Q,U&&Q_(q,Q?1:Ve.alpha)}}),dr=S,U&&Fn()}}ee&&tt&&Mt(om,oe,S=>{ce._lock||(et(S),dr!=null&&Zi(null,Jr,!0,un.setSeries))});function ji(S,T,U){let B=y[T];U&&(S=S/At-(B.ori==1?lt:Je));let q=H;B.ori==1&&(q=Pe,S=q-S),B.dir==-1&&(S=q-S);let Q=B._min,ue=B._max,ge=S/q,Me=Q+(ue-Q)*ge,Ue=B.distr;return Ue==3?ao(10,Me):Ue==4?wy(Me,B.asinh):Ue==100?B.bwd(Me):Me}function tx(S,T){let U=ji(S,b,T);return Di(U,e[0],rn,on)}i.valToIdx=S=>Di(S,e[0]),i.posToIdx=tx,i.posToVal=ji,i.valToPos=(S,T,U)=>y[T].ori==0?r(S,y[T],U?$:H,U?N:0):o(S,y[T],U?pe:Pe,U?w:0),i.setCursor=(S,T,U)=>{Xt=S.left,jt=S.top,fr(null,T,U)};function Zf(S,T){$t(jr,so,qt.left=S),$t(jr,ca,qt.width=T)}function jf(S,T){$t(jr,"top",qt.top=S),$t(jr,ha,qt.height=T)}let Qo=E.ori==0?Zf:jf,ea=E.ori==1?Zf:jf;function nx(){if(ee&&le.live)for(let S=s==2?1:0;S<M.length;S++){if(S==0&&at)continue;let T=le.values[S],U=0;for(let B in T)Be[S][U++].firstChild.nodeValue=T[B]}}function ou(S,T){if(S!=null&&(S.idxs?S.idxs.forEach((U,B)=>{te[B]=U}):Ry(S.idx)||te.fill(S.idx),le.idx=te[0]),ee&&le.live){for(let U=0;U<M.length;U++)(U>0||s==1&&!at)&&ix(U,te[U]);nx()}xe=!1,T!==!1&&An("setLegend")}i.setLegend=ou;function ix(S,T){let U=M[S],B=S==0&&L==2?oi:e[S],q;at?q=U.values(i,S,T)??Xe:(q=U.value(i,T==null?null:B[T],S,T),q=q==null?Xe:{_:q}),le.values[S]=q}function fr(S,T,U){Yf=Xt,$f=jt,[Xt,jt]=ce.move(i,Xt,jt),ce.left=Xt,ce.top=jt,me&&(qr&&ns(qr,yn(Xt),0,H,Pe),Yr&&ns(Yr,0,yn(jt),H,Pe));let B,q=rn>on;_s=zt,Os=null;let Q=E.ori==0?H:Pe,ue=E.ori==1?H:Pe;if(Xt<0||en==0||q){B=ce.idx=null;for(let ge=0;ge<M.length;ge++){let Me=ut[ge];Me!=null&&ns(Me,-10,-10,H,Pe)}tt&&Zi(null,Jr,!0,S==null&&un.setSeries),le.live&&(te.fill(B),xe=!0)}else{let ge,Me,Ue;s==1&&(ge=E.ori==0?Xt:jt,Me=ji(ge,b),B=ce.idx=Di(Me,e[0],rn,on),Ue=F(e[0][B],E,Q,0));let Fe=-10,ze=-10,ot=0,Tt=0,bt=!0,_t="",Qe="";for(let Ye=s==2?1:0;Ye<M.length;Ye++){let Yt=M[Ye],nn=te[Ye],Rn=nn==null?null:s==1?e[Ye][nn]:e[Ye][1][nn],Bt=ce.dataIdx(i,Ye,B,Me),sn=Bt==null?null:s==1?e[Ye][Bt]:e[Ye][1][Bt];if(xe=xe||sn!=Rn||Bt!=nn,te[Ye]=Bt,Ye>0&&Yt.show){let ai=Bt==null?-10:Bt==B?Ue:F(s==1?e[0][Bt]:e[Ye][0][Bt],E,Q,0),Wn=sn==null?-10:I(sn,s==1?y[Yt.scale]:y[Yt.facets[1].scale],ue,0);if(tt&&sn!=null){let vi=E.ori==1?Xt:jt,Ri=vn(Ve.dist(i,Ye,Bt,Wn,vi));if(Ri<_s){let Ji=Ve.bias;if(Ji!=0){let li=ji(vi,Yt.scale),Si=sn>=0?1:-1,Ci=li>=0?1:-1;Ci==Si&&(Ci==1?Ji==1?sn>=li:sn<=li:Ji==1?sn<=li:sn>=li)&&(_s=Ri,Os=Ye)}else _s=Ri,Os=Ye}}if(xe||Ce){let vi,Ri;E.ori==0?(vi=ai,Ri=Wn):(vi=Wn,Ri=ai);let Ji,li,Si,Ci,Ki,Xn,ci=!0,pr=fe.bbox;if(pr!=null){ci=!1;let qn=pr(i,Ye);Si=qn.left,Ci=qn.top,Ji=qn.width,li=qn.height}else Si=vi,Ci=Ri,Ji=li=fe.size(i,Ye);if(Xn=fe.fill(i,Ye),Ki=fe.stroke(i,Ye),Ce)Ye==Os&&_s<=Ve.prox&&(Fe=Si,ze=Ci,ot=Ji,Tt=li,bt=ci,_t=Xn,Qe=Ki);else{let qn=ut[Ye];qn!=null&&(Wt[Ye]=Si,Gn[Ye]=Ci,fm(qn,Ji,li,ci),um(qn,Xn,Ki),ns(qn,bi(Si),bi(Ci),H,Pe))}}}}if(Ce){let Ye=Ve.prox,Yt=dr==null?_s<=Ye:_s>Ye||Os!=dr;if(xe||Yt){let nn=ut[0];nn!=null&&(Wt[0]=Fe,Gn[0]=ze,fm(nn,ot,Tt,bt),um(nn,_t,Qe),ns(nn,bi(Fe),bi(ze),H,Pe))}}}if(qt.show&&Us)if(S!=null){let[ge,Me]=un.scales,[Ue,Fe]=un.match,[ze,ot]=S.cursor.sync.scales,Tt=S.cursor.drag;if(En=Tt._x,Tn=Tt._y,En||Tn){let{left:bt,top:_t,width:Qe,height:Ye}=S.select,Yt=S.scales[ze].ori,nn=S.posToVal,Rn,Bt,sn,ai,Wn,vi=ge!=null&&Ue(ge,ze),Ri=Me!=null&&Fe(Me,ot);vi&&En?(Yt==0?(Rn=bt,Bt=Qe):(Rn=_t,Bt=Ye),sn=y[ge],ai=F(nn(Rn,ze),sn,Q,0),Wn=F(nn(Rn+Bt,ze),sn,Q,0),Qo(Ni(ai,Wn),vn(Wn-ai))):Qo(0,Q),Ri&&Tn?(Yt==1?(Rn=bt,Bt=Qe):(Rn=_t,Bt=Ye),sn=y[Me],ai=I(nn(Rn,ot),sn,ue,0),Wn=I(nn(Rn+Bt,ot),sn,ue,0),ea(Ni(ai,Wn),vn(Wn-ai))):ea(0,ue)}else cu()}else{let ge=vn(Yf-Xf),Me=vn($f-qf);if(E.ori==1){let ot=ge;ge=Me,Me=ot}En=Pn.x&&ge>=Pn.dist,Tn=Pn.y&&Me>=Pn.dist;let Ue=Pn.uni;Ue!=null?En&&Tn&&(En=ge>=Ue,Tn=Me>=Ue,!En&&!Tn&&(Me>ge?Tn=!0:En=!0)):Pn.x&&Pn.y&&(En||Tn)&&(En=Tn=!0);let Fe,ze;En&&(E.ori==0?(Fe=$r,ze=Xt):(Fe=Zr,ze=jt),Qo(Ni(Fe,ze),vn(ze-Fe)),Tn||ea(0,ue)),Tn&&(E.ori==1?(Fe=$r,ze=Xt):(Fe=Zr,ze=jt),ea(Ni(Fe,ze),vn(ze-Fe)),En||Qo(0,Q)),!En&&!Tn&&(Qo(0,0),ea(0,0))}if(Pn._x=En,Pn._y=Tn,S==null){if(U){if(ap!=null){let[ge,Me]=un.scales;un.values[0]=ge!=null?ji(E.ori==0?Xt:jt,ge):null,un.values[1]=Me!=null?ji(E.ori==1?Xt:jt,Me):null}na(Nu,i,Xt,jt,H,Pe,B)}if(tt){let ge=U&&un.setSeries,Me=Ve.prox;dr==null?_s<=Me&&Zi(Os,Jr,!0,ge):_s>Me?Zi(null,Jr,!0,ge):Os!=dr&&Zi(Os,Jr,!0,ge)}}xe&&(le.idx=B,ou()),T!==!1&&An("setCursor")}let Bs=null;Object.defineProperty(i,"rect",{get(){return Bs==null&&ta(!1),Bs}});function ta(S=!1){S?Bs=null:(Bs=g.getBoundingClientRect(),An("syncRect",Bs))}function Jf(S,T,U,B,q,Q,ue){ce._lock||Us&&S!=null&&S.movementX==0&&S.movementY==0||(au(S,T,U,B,q,Q,ue,!1,S!=null),S!=null?fr(null,!0,!0):fr(T,!0,!1))}function au(S,T,U,B,q,Q,ue,ge,Me){if(Bs==null&&ta(!1),et(S),S!=null)U=S.clientX-Bs.left,B=S.clientY-Bs.top;else{if(U<0||B<0){Xt=-10,jt=-10;return}let[Ue,Fe]=un.scales,ze=T.cursor.sync,[ot,Tt]=ze.values,[bt,_t]=ze.scales,[Qe,Ye]=un.match,Yt=T.axes[0].side%2==1,nn=E.ori==0?H:Pe,Rn=E.ori==1?H:Pe,Bt=Yt?Q:q,sn=Yt?q:Q,ai=Yt?B:U,Wn=Yt?U:B;if(bt!=null?U=Qe(Ue,bt)?a(ot,y[Ue],nn,0):-10:U=nn*(ai/Bt),_t!=null?B=Ye(Fe,_t)?a(Tt,y[Fe],Rn,0):-10:B=Rn*(Wn/sn),E.ori==1){let vi=U;U=B,B=vi}}Me&&(T==null||T.cursor.event.type==Nu)&&((U<=1||U>=H-1)&&(U=vr(U,H)),(B<=1||B>=Pe-1)&&(B=vr(B,Pe))),ge?(Xf=U,qf=B,[$r,Zr]=ce.move(i,U,B)):(Xt=U,jt=B)}let lu={width:0,height:0,left:0,top:0};function cu(){gl(lu,!1)}let Kf,Qf,ep,tp;function np(S,T,U,B,q,Q,ue){Us=!0,En=Tn=Pn._x=Pn._y=!1,au(S,T,U,B,q,Q,ue,!0,!1),S!=null&&(Mt(Uu,zu,ip,!1),na(sm,i,$r,Zr,H,Pe,null));let{left:ge,top:Me,width:Ue,height:Fe}=qt;Kf=ge,Qf=Me,ep=Ue,tp=Fe}function ip(S,T,U,B,q,Q,ue){Us=Pn._x=Pn._y=!1,au(S,T,U,B,q,Q,ue,!1,!0);let{left:ge,top:Me,width:Ue,height:Fe}=qt,ze=Ue>0||Fe>0,ot=Kf!=ge||Qf!=Me||ep!=Ue||tp!=Fe;if(ze&&ot&&gl(qt),Pn.setScale&&ze&&ot){let Tt=ge,bt=Ue,_t=Me,Qe=Fe;if(E.ori==1&&(Tt=Me,bt=Fe,_t=ge,Qe=Ue),En&&Fs(b,ji(Tt,b),ji(Tt+bt,b)),Tn)for(let Ye in y){let Yt=y[Ye];Ye!=b&&Yt.from==null&&Yt.min!=zt&&Fs(Ye,ji(_t+Qe,Ye),ji(_t,Ye))}cu()}else ce.lock&&(ce._lock=!ce._lock,fr(T,!0,S!=null));S!=null&&(_n(Uu,zu),na(Uu,i,Xt,jt,H,Pe,null))}function sx(S,T,U,B,q,Q,ue){if(ce._lock)return;et(S);let ge=Us;if(Us){let Me=!0,Ue=!0,Fe=10,ze,ot;E.ori==0?(ze=En,ot=Tn):(ze=Tn,ot=En),ze&&ot&&(Me=Xt<=Fe||Xt>=H-Fe,Ue=jt<=Fe||jt>=Pe-Fe),ze&&Me&&(Xt=Xt<$r?0:H),ot&&Ue&&(jt=jt<Zr?0:Pe),fr(null,!0,!0),Us=!1}Xt=-10,jt=-10,te.fill(null),fr(null,!0,!0),ge&&(Us=ge)}function sp(S,T,U,B,q,Q,ue){ce._lock||(et(S),Ko(),cu(),S!=null&&na(am,i,Xt,jt,H,Pe,null))}function rp(){P.forEach(Wv),G(i.width,i.height,!0)}br(Dl,oo,rp);let Kr={};Kr.mousedown=np,Kr.mousemove=Jf,Kr.mouseup=ip,Kr.dblclick=sp,Kr.setSeries=(S,T,U,B)=>{let q=un.match[2];U=q(i,T,U),U!=-1&&Zi(U,B,!0,!1)},me&&(Mt(sm,g,np),Mt(Nu,g,Jf),Mt(rm,g,S=>{et(S),ta(!1)}),Mt(om,g,sx),Mt(am,g,sp),$u.add(i),i.syncRect=ta);let _l=i.hooks=n.hooks||{};function An(S,T,U){Hn?Ft.push([S,T,U]):S in _l&&_l[S].forEach(B=>{B.call(null,i,T,U)})}(n.plugins||[]).forEach(S=>{for(let T in S.hooks)_l[T]=(_l[T]||[]).concat(S.hooks[T])});let op=(S,T,U)=>U,un=pn({key:null,setSeries:!1,filters:{pub:xm,sub:xm},scales:[b,M[1]?M[1].scale:null],match:[ym,ym,op],values:[null,null]},ce.sync);un.match.length==2&&un.match.push(op),ce.sync=un;let ap=un.key,hu=mg(ap);function na(S,T,U,B,q,Q,ue){un.filters.pub(S,T,U,B,q,Q,ue)&&hu.pub(S,T,U,B,q,Q,ue)}hu.sub(i);function rx(S,T,U,B,q,Q,ue){un.filters.sub(S,T,U,B,q,Q,ue)&&Kr[S](null,T,U,B,q,Q,ue)}i.pub=rx;function ox(){hu.unsub(i),$u.delete(i),wn.clear(),Hu(Dl,oo,rp),c.remove(),oe?.remove(),An("destroy")}i.destroy=ox;function uu(){An("init",n,e),Jo(e||n.data,!1),O[b]?iu(b,O[b]):Ko(),re=qt.show&&(qt.width>0||qt.height>0),ie=xe=!0,G(n.width,n.height)}return M.forEach(Gr),P.forEach(fs),t?t instanceof HTMLElement?(t.appendChild(c),uu()):t(i,uu):uu(),i}In.assign=pn;In.fmtNum=td;In.rangeNum=Nl;In.rangeLog=Ol;In.rangeAsinh=Qu;In.orient=Er;In.pxRatio=At;In.join=Uy;In.fmtDate=id,In.tzDate=qy;In.sync=mg;{In.addGap=Rv,In.clipGaps=zl;let n=In.paths={points:Sg};n.linear=bg,n.stepped=Iv,n.bars=Lv,n.spline=Nv}var Xv="robot-dynamics",Tr=n=>getComputedStyle(document.documentElement).getPropertyValue(n).trim();function qv(n){let{joints:e,ofBase:t,units:i,trajectory:s}=n,{name:r}=n.tip(),o=(d,u,m)=>({values:s[d].map(g=>g[u]*m),now:g=>g[d][u]*m}),a=(d,u,m,g)=>({key:d,title:u,curves:e.map((x,f)=>({joint:f,name:x.name,unit:m(x.type),color:`--joint-${f%8}`,isDashed:f>=8,...o(d,d==="q"?f:t+f,g?i.factor(x.type):1)}))}),l=(d,u,m,g,x,f)=>({joint:null,name:d,sign:u,values:m,unit:g,color:x,now:f}),c=d=>s.tip.map(u=>u[d]),h=[a("q",["q","positions"],i.position,!0),a("qd",["q\u0307","velocities"],i.velocity,!0),a("qdd",["q\u0308","accelerations"],i.acceleration,!0),a("tau",["\u03C4","torques and forces"],i.force,!1),{key:"energy",title:["E","energies"],curves:[l("kinetic","T",s.kinetic,"J","--joint-0",({kinetic:d})=>d),l("potential","U",s.potential,"J","--joint-1",({potential:d})=>d),l("total","T+U",s.total,"J","--ink",({kinetic:d,potential:u})=>d+u)]},{key:"tip",title:["p",r],curves:[0,1,2].map(d=>l("xyz"[d],"xyz"[d],c(d),"m",`--axis-${"xyz"[d]}`,({tip:u})=>u[d][3]))}];return t>0?[...h.filter(({curves:d})=>d.length>0),...Yv(n,o)]:h}function Yv({freedoms:n,ofBase:e,units:t,trajectory:i},s){let r=(c,h,d,u,m)=>({key:`base-${c}`,title:h,curves:n.slice(0,e).map((g,x)=>({joint:null,name:g.name,sign:d(g),unit:u(g.type),color:`--axis-${g.axis}`,isDashed:x>=3,...s(c,x,m?t.factor(g.type):1)}))}),o=[0,1,2].map(c=>({joint:null,name:"xyz"[c],sign:"xyz"[c],unit:"m",color:`--axis-${"xyz"[c]}`,values:i.base.map(h=>ts(h)[c]),now:({base:h})=>ts(h)[c]})),a=({velocity:c,axis:h})=>`${c}${h}`,l=({force:c,axis:h})=>`${c}${h}`;return[{key:"base",title:["p","base"],curves:o},r("qd",["v, \u03C9","of the base"],a,t.velocity,!0),r("tau",["f, n","acting on the base"],l,t.force,!1)]}function $v(n,e){if(n===null||!Number.isFinite(n+e))return[-1,1];let t=e-n,i=Math.max(Math.abs(n),Math.abs(e));return t<=1e-9*i||t<1e-12?i<1e-12?[-1,1]:[n-.5*i,e+.5*i]:[n-.06*t,e+.06*t]}function Zv(n,e,t,i){let[s,r,o]=["--ink","--line","--muted"].map(Tr),a=[...new Set(n.curves.map(({unit:h})=>h))],l="11px system-ui, sans-serif",c=(h,d,u)=>({scale:h,side:d,stroke:o,font:l,size:46,gap:3,grid:{show:u,stroke:r,width:1},ticks:{show:!1},values:(m,g)=>g.map(x=>String(Number(x.toPrecision(6))))});return{width:e,height:t,padding:[8,a.length>1?0:12,0,0],legend:{show:!1},cursor:{sync:{key:Xv},drag:{x:!1,y:!1},points:{size:6},y:!1},focus:{alpha:.3},scales:{x:{time:!1,range:()=>[i[0],i[i.length-1]||1]},...Object.fromEntries(a.map(h=>[h,{range:(d,u,m)=>$v(u,m)}]))},axes:[{stroke:o,font:l,size:26,gap:3,grid:{stroke:r,width:1},ticks:{show:!1},values:(h,d)=>d.map(u=>`${Number(u.toPrecision(6))}`)},...a.map((h,d)=>c(h,d===0?3:1,d===0))],series:[{},...n.curves.map(({name:h,unit:d,color:u,isDashed:m})=>({label:h,scale:d,stroke:Tr(u)||s,width:1.8,dash:m?[5,4]:void 0,points:{show:!1}}))]}}function Ag(n){let{joints:e}=n,t=new Set,i=z("div",{class:"plots"}),s=z("p",{class:"status",role:"status","data-key":"status"}),r=[],o=z("div",{class:"legend",role:"group","aria-label":"Joints in the plots"},e.map((x,f)=>{let p=z("button",{type:"button",class:"chip","aria-pressed":!0});return p.style.setProperty("--color",`var(--joint-${f%8})`),p.append(z("span",{class:"dot"}),x.name),p.addEventListener("click",()=>{t.delete(f)||t.add(f),p.setAttribute("aria-pressed",!t.has(f)),r.forEach(({plot:M,chart:P,readings:y})=>M.curves.forEach(({joint:A},b)=>{A===f&&(P.setSeries(b+1,{show:!t.has(f)}),y[b].hidden=t.has(f))}))}),p})),a=z("button",{type:"button",class:"quiet","data-key":"csv"},"Save as CSV");a.addEventListener("click",()=>{let x=n.freedoms.map(M=>M.name),f=Xp(n.trajectory,x),p=z("a",{href:URL.createObjectURL(new Blob([f],{type:"text/csv"}))});p.download=`${n.table.name}.csv`,p.click(),setTimeout(()=>URL.revokeObjectURL(p.href),1e3)});function l(){let{trajectory:x}=n;if(r.forEach(({chart:p})=>p.destroy()),r=[],i.replaceChildren(),g.hidden=x===null,!x)return;d();let f=x.t.length>1;if(a.disabled=!f,!!f){for(let p of qv(n)){let[M,P]=p.title,y=[...new Set(p.curves.map(({unit:L})=>L))],A=p.curves.map(({color:L,sign:F,joint:I})=>{let O=z("span",{class:"reading"});return O.style.setProperty("--color",`var(${L})`),O.append(...F?[z("i",{},F)]:dn(M,I+1)," ",z("data")),O}),b=z("div",{class:"chart",role:"img","aria-label":`${P} over time, ${y.join(" and ")}`}),_=z("figure",{"data-plot":p.key},z("figcaption",{},z("b",{},z("i",{},M)),` ${P}, ${y.join(" and ")}`),z("div",{class:"readings"},A),b);i.append(_);let v=168,D=[x.t,...p.curves.map(({values:L})=>L)],C=new In(Zv(p,Math.max(b.clientWidth,120),v,x.t),D,b),E=z("div",{class:"playhead"});C.over.append(E),c(C),p.curves.forEach(({joint:L},F)=>{L===null||!t.has(L)||(C.setSeries(F+1,{show:!1}),A[F].hidden=!0)}),r.push({plot:p,chart:C,head:E,readings:A,canvas:b})}m(),h()}}function c(x){let f=p=>{let{left:M}=x.over.getBoundingClientRect();n.play(!1),n.setTime(x.posToVal(p.clientX-M,"x"))};x.over.addEventListener("pointerdown",p=>{x.over.setPointerCapture(p.pointerId),f(p)}),x.over.addEventListener("pointermove",p=>{x.over.hasPointerCapture(p.pointerId)&&f(p)})}function h(){let{trajectory:x,state:f}=n;if(!x||r.length===0)return;let p=n.evaluated();for(let{plot:M,chart:P,head:y,readings:A}of r)y.style.transform=`translateX(${P.valToPos(f.t,"x")}px)`,M.curves.forEach(({now:b},_)=>{let v=A[_].lastChild;v.value=String(b(p)),v.textContent=mr(b(p))})}function d(){let{trajectory:x,state:f,table:p}=n,M=[],P=x.t.length>1;if(x.ended){let{t:y,reason:A}=x.ended;M.push(P?`Ends at ${mr(y)} s: ${A}.`:`The motion cannot begin: ${A}.`)}if(f.mode==="free"&&P){let y=x.energyScale>0?x.drift/x.energyScale:0;M.push(`Integrated by DOP853. Energy and work balance to ${x.drift.toExponential(1)} J, ${y.toExponential(1)} of what is exchanged.`);let A=e.filter((b,_)=>{let{limits:v}=p.rows.find(D=>D.joint===_);return v&&x.q.some(D=>D[_]<v[0]-1e-9||D[_]>v[1]+1e-9)});A.length>0&&M.push(`Limits are no stops here: ${A.map(b=>b.name).join(", ")} passed them.`)}s.textContent=M.join(" "),s.classList.toggle("warning",!!x.ended)}let u=new ResizeObserver(()=>{for(let{chart:x,canvas:f}of r){let p=f.clientWidth;p>0&&p!==x.width&&x.setSize({width:p,height:x.height})}h()}),m=()=>r.forEach(({canvas:x})=>u.observe(x)),g=z("section",{class:"panel","aria-label":"Plots"},z("div",{class:"bar"},o,a),s,i);return n.on("trajectory units theme",()=>g.isConnected&&l()),n.on("time",h),{section:g,build:l}}var nr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},ir={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},r0=0,kd=1,o0=2;var Ka=1,a0=2,Vo=3,sr=0,ti=1,os=2,Dr=0,Go=1,zd=2,Vd=3,Gd=4,l0=5;var Nr=100,c0=101,h0=102,u0=103,d0=104,f0=200,p0=201,m0=202,g0=203,Hd=204,Wd=205,_0=206,x0=207,y0=208,v0=209,S0=210,M0=211,b0=212,w0=213,E0=214,mc=0,gc=1,_c=2,Io=3,xc=4,yc=5,vc=6,Sc=7,Xd=0,T0=1,A0=2,as=0,qd=1,Yd=2,$d=3,Zd=4,jd=5,Jd=6,Kd=7;var Qd=300,Ur=301,Ho=302,Kc=303,Qc=304,Mc=1e3,ss=1001,bc=1002,gn=1003,R0=1004;var Qa=1005;var Kn=1006,eh=1007;var Cs=1008;var si=1009,ef=1010,tf=1011,Wo=1012,th=1013,Gi=1014,Hi=1015,Wi=1016,nh=1017,ih=1018,Fr=1020,nf=35902,sf=35899,rf=1021,of=1022,Xi=1023,Ts=1026,Ps=1027,af=1028,sh=1029,rr=1030,rh=1031;var oh=1033,el=33776,tl=33777,nl=33778,il=33779,ah=35840,lh=35841,ch=35842,hh=35843,uh=36196,dh=37492,fh=37496,ph=37488,mh=37489,sl=37490,gh=37491,_h=37808,xh=37809,yh=37810,vh=37811,Sh=37812,Mh=37813,bh=37814,wh=37815,Eh=37816,Th=37817,Ah=37818,Rh=37819,Ch=37820,Ph=37821,Ih=36492,Lh=36494,Dh=36495,Nh=36283,Uh=36284,rl=36285,Fh=36286;var ba=2300,wc=2301,fc=2302,Ld=2303,Dd=2400,Nd=2401,Ud=2402;var C0=3200;var Oh=0,P0=1,Is="",Zn="srgb",wa="srgb-linear",Ea="linear",Lt="srgb";var pc=7680;var I0=519,L0=512,D0=513,N0=514,lf=515,U0=516,F0=517,cf=518,hf=519,uf=35044;var df="300 es",Ei=2e3,Lo=2001;function jv(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function Jv(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Ta(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function O0(){let n=Ta("canvas");return n.style.display="block",n}var Rg={},Do=null;function Aa(...n){let e="THREE."+n.shift();Do?Do("log",e,...n):console.log(e,...n)}function B0(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function je(...n){n=B0(n);let e="THREE."+n.shift();if(Do)Do("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function it(...n){n=B0(n);let e="THREE."+n.shift();if(Do)Do("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function va(...n){let e=n.join(" ");e in Rg||(Rg[e]=!0,je(...n))}function k0(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var z0={[mc]:mc,[_c]:vc,[xc]:xc,[Io]:yc,[gc]:gc,[vc]:_c,[Sc]:Sc,[yc]:Io},ki=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Bn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Cg=1234567,Sa=Math.PI/180,No=180/Math.PI;function or(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Bn[n&255]+Bn[n>>8&255]+Bn[n>>16&255]+Bn[n>>24&255]+"-"+Bn[e&255]+Bn[e>>8&255]+"-"+Bn[e>>16&15|64]+Bn[e>>24&255]+"-"+Bn[t&63|128]+Bn[t>>8&255]+"-"+Bn[t>>16&255]+Bn[t>>24&255]+Bn[i&255]+Bn[i>>8&255]+Bn[i>>16&255]+Bn[i>>24&255]).toLowerCase()}function ct(n,e,t){return Math.max(e,Math.min(t,n))}function ff(n,e){return(n%e+e)%e}function Kv(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function Qv(n,e,t){return n!==e?(t-n)/(e-n):0}function Ma(n,e,t){return(1-t)*n+t*e}function eS(n,e,t,i){return Ma(n,e,1-Math.exp(-t*i))}function tS(n,e=1){return e-Math.abs(ff(n,e*2)-e)}function nS(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function iS(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function sS(n,e){return n+Math.floor(Math.random()*(e-n+1))}function rS(n,e){return n+Math.random()*(e-n)}function oS(n){return n*(.5-Math.random())}function aS(n){n!==void 0&&(Cg=n);let e=Cg+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function lS(n){return n*Sa}function cS(n){return n*No}function hS(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function uS(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function pf(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function dS(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),h=o((e+i)/2),d=r((e-i)/2),u=o((e-i)/2),m=r((i-e)/2),g=o((i-e)/2);switch(s){case"XYX":n.set(a*h,l*d,l*u,a*c);break;case"YZY":n.set(l*u,a*h,l*d,a*c);break;case"ZXZ":n.set(l*d,l*u,a*h,a*c);break;case"XZX":n.set(a*h,l*g,l*m,a*c);break;case"YXY":n.set(l*m,a*h,l*g,a*c);break;case"ZYZ":n.set(l*g,l*m,a*h,a*c);break;default:je("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Bh(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function mf(n,e){if(e.constructor===Float32Array)return n;let t=Bh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function gf(n,e){if(e.constructor===Float32Array)return n;let t=Bh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var ol={DEG2RAD:Sa,RAD2DEG:No,generateUUID:or,clamp:ct,euclideanModulo:ff,mapLinear:Kv,inverseLerp:Qv,lerp:Ma,damp:eS,pingpong:tS,smoothstep:nS,smootherstep:iS,randInt:sS,randFloat:rS,randFloatSpread:oS,seededRandom:aS,degToRad:lS,radToDeg:cS,isPowerOfTwo:hS,ceilPowerOfTwo:uS,floorPowerOfTwo:pf,setQuaternionFromProperEuler:dS,normalize:gf,denormalize:mf},Sf=class Sf{constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};Sf.prototype.isVector2=!0;var Ke=Sf,Qn=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],h=i[s+2],d=i[s+3],u=r[o+0],m=r[o+1],g=r[o+2],x=r[o+3];if(d!==x||l!==u||c!==m||h!==g){let f=l*u+c*m+h*g+d*x;f<0&&(u=-u,m=-m,g=-g,x=-x,f=-f);let p=1-a;if(f<.9995){let M=Math.acos(f),P=Math.sin(M);p=Math.sin(p*M)/P,a=Math.sin(a*M)/P,l=l*p+u*a,c=c*p+m*a,h=h*p+g*a,d=d*p+x*a}else{l=l*p+u*a,c=c*p+m*a,h=h*p+g*a,d=d*p+x*a;let M=1/Math.sqrt(l*l+c*c+h*h+d*d);l*=M,c*=M,h*=M,d*=M}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=d}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],h=i[s+3],d=r[o],u=r[o+1],m=r[o+2],g=r[o+3];return e[t]=a*g+h*d+l*m-c*u,e[t+1]=l*g+h*u+c*d-a*m,e[t+2]=c*g+h*m+a*u-l*d,e[t+3]=h*g-a*d-l*u-c*m,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),h=a(s/2),d=a(r/2),u=l(i/2),m=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=u*h*d+c*m*g,this._y=c*m*d-u*h*g,this._z=c*h*g+u*m*d,this._w=c*h*d-u*m*g;break;case"YXZ":this._x=u*h*d+c*m*g,this._y=c*m*d-u*h*g,this._z=c*h*g-u*m*d,this._w=c*h*d+u*m*g;break;case"ZXY":this._x=u*h*d-c*m*g,this._y=c*m*d+u*h*g,this._z=c*h*g+u*m*d,this._w=c*h*d-u*m*g;break;case"ZYX":this._x=u*h*d-c*m*g,this._y=c*m*d+u*h*g,this._z=c*h*g-u*m*d,this._w=c*h*d+u*m*g;break;case"YZX":this._x=u*h*d+c*m*g,this._y=c*m*d+u*h*g,this._z=c*h*g-u*m*d,this._w=c*h*d-u*m*g;break;case"XZY":this._x=u*h*d-c*m*g,this._y=c*m*d-u*h*g,this._z=c*h*g+u*m*d,this._w=c*h*d+u*m*g;break;default:je("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],d=t[10],u=i+a+d;if(u>0){let m=.5/Math.sqrt(u+1);this._w=.25/m,this._x=(h-l)*m,this._y=(r-c)*m,this._z=(o-s)*m}else if(i>a&&i>d){let m=2*Math.sqrt(1+i-a-d);this._w=(h-l)/m,this._x=.25*m,this._y=(s+o)/m,this._z=(r+c)/m}else if(a>d){let m=2*Math.sqrt(1+a-i-d);this._w=(r-c)/m,this._x=(s+o)/m,this._y=.25*m,this._z=(l+h)/m}else{let m=2*Math.sqrt(1+d-i-a);this._w=(o-s)/m,this._x=(r+c)/m,this._y=(l+h)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ct(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=i*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-i*c,this._z=r*h+o*c+i*l-s*a,this._w=o*h-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},Mf=class Mf{constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Pg.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Pg.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),h=2*(a*t-r*s),d=2*(r*i-o*t);return this.x=t+l*c+o*d-a*h,this.y=i+l*h+a*c-r*d,this.z=s+l*d+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return hd.copy(this).projectOnVector(e),this.sub(hd)}reflect(e){return this.sub(hd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}};Mf.prototype.isVector3=!0;var X=Mf,hd=new X,Pg=new Qn,bf=class bf{constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=i,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],h=i[4],d=i[7],u=i[2],m=i[5],g=i[8],x=s[0],f=s[3],p=s[6],M=s[1],P=s[4],y=s[7],A=s[2],b=s[5],_=s[8];return r[0]=o*x+a*M+l*A,r[3]=o*f+a*P+l*b,r[6]=o*p+a*y+l*_,r[1]=c*x+h*M+d*A,r[4]=c*f+h*P+d*b,r[7]=c*p+h*y+d*_,r[2]=u*x+m*M+g*A,r[5]=u*f+m*P+g*b,r[8]=u*p+m*y+g*_,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-i*r*h+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],d=h*o-a*c,u=a*l-h*r,m=c*r-o*l,g=t*d+i*u+s*m;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/g;return e[0]=d*x,e[1]=(s*c-h*i)*x,e[2]=(a*i-s*o)*x,e[3]=u*x,e[4]=(h*t-s*l)*x,e[5]=(s*r-a*t)*x,e[6]=m*x,e[7]=(i*l-c*t)*x,e[8]=(o*t-i*r)*x,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return va("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ud.makeScale(e,t)),this}rotate(e){return va("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ud.makeRotation(-e)),this}translate(e,t){return va("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ud.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}};bf.prototype.isMatrix3=!0;var rt=bf,ud=new rt,Ig=new rt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Lg=new rt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function fS(){let n={enabled:!0,workingColorSpace:wa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Lt&&(s.r=Es(s.r),s.g=Es(s.g),s.b=Es(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Lt&&(s.r=Po(s.r),s.g=Po(s.g),s.b=Po(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Is?Ea:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[wa]:{primaries:e,whitePoint:i,transfer:Ea,toXYZ:Ig,fromXYZ:Lg,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Zn},outputColorSpaceConfig:{drawingBufferColorSpace:Zn}},[Zn]:{primaries:e,whitePoint:i,transfer:Lt,toXYZ:Ig,fromXYZ:Lg,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Zn}}}),n}var vt=fS();function Es(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Po(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var mo,Ec=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{mo===void 0&&(mo=Ta("canvas")),mo.width=e.width,mo.height=e.height;let s=mo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=mo}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ta("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Es(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Es(t[i]/255)*255):t[i]=Es(t[i]);return{data:t,width:e.width,height:e.height}}else return je("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},pS=0,Uo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:pS++}),this.uuid=or(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(dd(s[o].image)):r.push(dd(s[o]))}else r=dd(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function dd(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Ec.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(je("Texture: Unable to serialize Texture."),{})}var mS=0,fd=new X,ei=class n extends ki{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=ss,s=ss,r=Kn,o=Cs,a=Xi,l=si,c=n.DEFAULT_ANISOTROPY,h=Is){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:mS++}),this.uuid=or(),this.name="",this.source=new Uo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ke(0,0),this.repeat=new Ke(1,1),this.center=new Ke(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new rt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(fd).x}get height(){return this.source.getSize(fd).y}get depth(){return this.source.getSize(fd).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){je(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){je(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Qd)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Mc:e.x=e.x-Math.floor(e.x);break;case ss:e.x=e.x<0?0:1;break;case bc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Mc:e.y=e.y-Math.floor(e.y);break;case ss:e.y=e.y<0?0:1;break;case bc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ei.DEFAULT_IMAGE=null;ei.DEFAULT_MAPPING=Qd;ei.DEFAULT_ANISOTROPY=1;var wf=class wf{constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],h=l[4],d=l[8],u=l[1],m=l[5],g=l[9],x=l[2],f=l[6],p=l[10];if(Math.abs(h-u)<.01&&Math.abs(d-x)<.01&&Math.abs(g-f)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+x)<.1&&Math.abs(g+f)<.1&&Math.abs(c+m+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let P=(c+1)/2,y=(m+1)/2,A=(p+1)/2,b=(h+u)/4,_=(d+x)/4,v=(g+f)/4;return P>y&&P>A?P<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(P),s=b/i,r=_/i):y>A?y<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(y),i=b/s,r=v/s):A<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),i=_/r,s=v/r),this.set(i,s,r,t),this}let M=Math.sqrt((f-g)*(f-g)+(d-x)*(d-x)+(u-h)*(u-h));return Math.abs(M)<.001&&(M=1),this.x=(f-g)/M,this.y=(d-x)/M,this.z=(u-h)/M,this.w=Math.acos((c+m+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this.w=ct(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this.w=ct(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};wf.prototype.isVector4=!0;var Dt=wf,Tc=class extends ki{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Kn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Dt(0,0,e,t),this.scissorTest=!1,this.viewport=new Dt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new ei({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Kn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Uo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},_i=class extends Tc{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Ra=class extends ei{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=gn,this.minFilter=gn,this.wrapR=ss,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Ac=class extends ei{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=gn,this.minFilter=gn,this.wrapR=ss,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Jc=class Jc{constructor(e,t,i,s,r,o,a,l,c,h,d,u,m,g,x,f){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,h,d,u,m,g,x,f)}set(e,t,i,s,r,o,a,l,c,h,d,u,m,g,x,f){let p=this.elements;return p[0]=e,p[4]=t,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=h,p[10]=d,p[14]=u,p[3]=m,p[7]=g,p[11]=x,p[15]=f,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Jc().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/go.setFromMatrixColumn(e,0).length(),r=1/go.setFromMatrixColumn(e,1).length(),o=1/go.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),d=Math.sin(r);if(e.order==="XYZ"){let u=o*h,m=o*d,g=a*h,x=a*d;t[0]=l*h,t[4]=-l*d,t[8]=c,t[1]=m+g*c,t[5]=u-x*c,t[9]=-a*l,t[2]=x-u*c,t[6]=g+m*c,t[10]=o*l}else if(e.order==="YXZ"){let u=l*h,m=l*d,g=c*h,x=c*d;t[0]=u+x*a,t[4]=g*a-m,t[8]=o*c,t[1]=o*d,t[5]=o*h,t[9]=-a,t[2]=m*a-g,t[6]=x+u*a,t[10]=o*l}else if(e.order==="ZXY"){let u=l*h,m=l*d,g=c*h,x=c*d;t[0]=u-x*a,t[4]=-o*d,t[8]=g+m*a,t[1]=m+g*a,t[5]=o*h,t[9]=x-u*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let u=o*h,m=o*d,g=a*h,x=a*d;t[0]=l*h,t[4]=g*c-m,t[8]=u*c+x,t[1]=l*d,t[5]=x*c+u,t[9]=m*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let u=o*l,m=o*c,g=a*l,x=a*c;t[0]=l*h,t[4]=x-u*d,t[8]=g*d+m,t[1]=d,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=m*d+g,t[10]=u-x*d}else if(e.order==="XZY"){let u=o*l,m=o*c,g=a*l,x=a*c;t[0]=l*h,t[4]=-d,t[8]=c*h,t[1]=u*d+x,t[5]=o*h,t[9]=m*d-g,t[2]=g*d-m,t[6]=a*h,t[10]=x*d+u}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(gS,e,_S)}lookAt(e,t,i){let s=this.elements;return pi.subVectors(e,t),pi.lengthSq()===0&&(pi.z=1),pi.normalize(),Ws.crossVectors(i,pi),Ws.lengthSq()===0&&(Math.abs(i.z)===1?pi.x+=1e-4:pi.z+=1e-4,pi.normalize(),Ws.crossVectors(i,pi)),Ws.normalize(),Wl.crossVectors(pi,Ws),s[0]=Ws.x,s[4]=Wl.x,s[8]=pi.x,s[1]=Ws.y,s[5]=Wl.y,s[9]=pi.y,s[2]=Ws.z,s[6]=Wl.z,s[10]=pi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],h=i[1],d=i[5],u=i[9],m=i[13],g=i[2],x=i[6],f=i[10],p=i[14],M=i[3],P=i[7],y=i[11],A=i[15],b=s[0],_=s[4],v=s[8],D=s[12],C=s[1],E=s[5],L=s[9],F=s[13],I=s[2],O=s[6],V=s[10],k=s[14],K=s[3],Y=s[7],Z=s[11],te=s[15];return r[0]=o*b+a*C+l*I+c*K,r[4]=o*_+a*E+l*O+c*Y,r[8]=o*v+a*L+l*V+c*Z,r[12]=o*D+a*F+l*k+c*te,r[1]=h*b+d*C+u*I+m*K,r[5]=h*_+d*E+u*O+m*Y,r[9]=h*v+d*L+u*V+m*Z,r[13]=h*D+d*F+u*k+m*te,r[2]=g*b+x*C+f*I+p*K,r[6]=g*_+x*E+f*O+p*Y,r[10]=g*v+x*L+f*V+p*Z,r[14]=g*D+x*F+f*k+p*te,r[3]=M*b+P*C+y*I+A*K,r[7]=M*_+P*E+y*O+A*Y,r[11]=M*v+P*L+y*V+A*Z,r[15]=M*D+P*F+y*k+A*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],d=e[6],u=e[10],m=e[14],g=e[3],x=e[7],f=e[11],p=e[15],M=l*m-c*u,P=a*m-c*d,y=a*u-l*d,A=o*m-c*h,b=o*u-l*h,_=o*d-a*h;return t*(x*M-f*P+p*y)-i*(g*M-f*A+p*b)+s*(g*P-x*A+p*_)-r*(g*y-x*b+f*_)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-i*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],d=e[9],u=e[10],m=e[11],g=e[12],x=e[13],f=e[14],p=e[15],M=t*a-i*o,P=t*l-s*o,y=t*c-r*o,A=i*l-s*a,b=i*c-r*a,_=s*c-r*l,v=h*x-d*g,D=h*f-u*g,C=h*p-m*g,E=d*f-u*x,L=d*p-m*x,F=u*p-m*f,I=M*F-P*L+y*E+A*C-b*D+_*v;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let O=1/I;return e[0]=(a*F-l*L+c*E)*O,e[1]=(s*L-i*F-r*E)*O,e[2]=(x*_-f*b+p*A)*O,e[3]=(u*b-d*_-m*A)*O,e[4]=(l*C-o*F-c*D)*O,e[5]=(t*F-s*C+r*D)*O,e[6]=(f*y-g*_-p*P)*O,e[7]=(h*_-u*y+m*P)*O,e[8]=(o*L-a*C+c*v)*O,e[9]=(i*C-t*L-r*v)*O,e[10]=(g*b-x*y+p*M)*O,e[11]=(d*y-h*b-m*M)*O,e[12]=(a*D-o*E-l*v)*O,e[13]=(t*E-i*D+s*v)*O,e[14]=(x*P-g*A-f*M)*O,e[15]=(h*A-d*P+u*M)*O,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+i,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,d=a+a,u=r*c,m=r*h,g=r*d,x=o*h,f=o*d,p=a*d,M=l*c,P=l*h,y=l*d,A=i.x,b=i.y,_=i.z;return s[0]=(1-(x+p))*A,s[1]=(m+y)*A,s[2]=(g-P)*A,s[3]=0,s[4]=(m-y)*b,s[5]=(1-(u+p))*b,s[6]=(f+M)*b,s[7]=0,s[8]=(g+P)*_,s[9]=(f-M)*_,s[10]=(1-(u+x))*_,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=go.set(s[0],s[1],s[2]).length(),a=go.set(s[4],s[5],s[6]).length(),l=go.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ui.copy(this);let c=1/o,h=1/a,d=1/l;return Ui.elements[0]*=c,Ui.elements[1]*=c,Ui.elements[2]*=c,Ui.elements[4]*=h,Ui.elements[5]*=h,Ui.elements[6]*=h,Ui.elements[8]*=d,Ui.elements[9]*=d,Ui.elements[10]*=d,t.setFromRotationMatrix(Ui),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Ei,l=!1){let c=this.elements,h=2*r/(t-e),d=2*r/(i-s),u=(t+e)/(t-e),m=(i+s)/(i-s),g,x;if(l)g=r/(o-r),x=o*r/(o-r);else if(a===Ei)g=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===Lo)g=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=d,c[9]=m,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Ei,l=!1){let c=this.elements,h=2/(t-e),d=2/(i-s),u=-(t+e)/(t-e),m=-(i+s)/(i-s),g,x;if(l)g=1/(o-r),x=o/(o-r);else if(a===Ei)g=-2/(o-r),x=-(o+r)/(o-r);else if(a===Lo)g=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=d,c[9]=0,c[13]=m,c[2]=0,c[6]=0,c[10]=g,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}};Jc.prototype.isMatrix4=!0;var Ot=Jc,go=new X,Ui=new Ot,gS=new X(0,0,0),_S=new X(1,1,1),Ws=new X,Wl=new X,pi=new X,Dg=new Ot,Ng=new Qn,As=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],d=s[2],u=s[6],m=s[10];switch(t){case"XYZ":this._y=Math.asin(ct(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,m),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ct(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,m),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(ct(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,m),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ct(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,m),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ct(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,m));break;case"XZY":this._z=Math.asin(-ct(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,m),this._y=0);break;default:je("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Dg.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Dg,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Ng.setFromEuler(this),this.setFromQuaternion(Ng,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};As.DEFAULT_ORDER="XYZ";var Ca=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},xS=0,Ug=new X,_o=new Qn,vs=new Ot,Xl=new X,ma=new X,yS=new X,vS=new Qn,Fg=new X(1,0,0),Og=new X(0,1,0),Bg=new X(0,0,1),kg={type:"added"},SS={type:"removed"},xo={type:"childadded",child:null},pd={type:"childremoved",child:null},Ln=class n extends ki{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:xS++}),this.uuid=or(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new X,t=new As,i=new Qn,s=new X(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ot},normalMatrix:{value:new rt}}),this.matrix=new Ot,this.matrixWorld=new Ot,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ca,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return _o.setFromAxisAngle(e,t),this.quaternion.multiply(_o),this}rotateOnWorldAxis(e,t){return _o.setFromAxisAngle(e,t),this.quaternion.premultiply(_o),this}rotateX(e){return this.rotateOnAxis(Fg,e)}rotateY(e){return this.rotateOnAxis(Og,e)}rotateZ(e){return this.rotateOnAxis(Bg,e)}translateOnAxis(e,t){return Ug.copy(e).applyQuaternion(this.quaternion),this.position.add(Ug.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Fg,e)}translateY(e){return this.translateOnAxis(Og,e)}translateZ(e){return this.translateOnAxis(Bg,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(vs.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Xl.copy(e):Xl.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),ma.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?vs.lookAt(ma,Xl,this.up):vs.lookAt(Xl,ma,this.up),this.quaternion.setFromRotationMatrix(vs),s&&(vs.extractRotation(s.matrixWorld),_o.setFromRotationMatrix(vs),this.quaternion.premultiply(_o.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(it("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(kg),xo.child=e,this.dispatchEvent(xo),xo.child=null):it("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(SS),pd.child=e,this.dispatchEvent(pd),pd.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),vs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),vs.multiply(e.parent.matrixWorld)),e.applyMatrix4(vs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(kg),xo.child=e,this.dispatchEvent(xo),xo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ma,e,yS),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ma,vS,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let d=l[c];r(e.shapes,d)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),d=o(e.shapes),u=o(e.skeletons),m=o(e.animations),g=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),d.length>0&&(i.shapes=d),u.length>0&&(i.skeletons=u),m.length>0&&(i.animations=m),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Ln.DEFAULT_UP=new X(0,1,0);Ln.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ln.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Jn=class extends Ln{constructor(){super(),this.isGroup=!0,this.type="Group"}},MS={type:"move"},Fo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Jn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Jn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new X,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new X),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Jn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new X,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new X,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let x of e.hand.values()){let f=t.getJointPose(x,i),p=this._getHandJoint(c,x);f!==null&&(p.matrix.fromArray(f.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=f.radius),p.visible=f!==null}let h=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],u=h.position.distanceTo(d.position),m=.02,g=.005;c.inputState.pinching&&u>m+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&u<=m-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(MS)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Jn;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},V0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Xs={h:0,s:0,l:0},ql={h:0,s:0,l:0};function md(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var ht=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Zn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,vt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=vt.workingColorSpace){return this.r=e,this.g=t,this.b=i,vt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=vt.workingColorSpace){if(e=ff(e,1),t=ct(t,0,1),i=ct(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=md(o,r,e+1/3),this.g=md(o,r,e),this.b=md(o,r,e-1/3)}return vt.colorSpaceToWorking(this,s),this}setStyle(e,t=Zn){function i(r){r!==void 0&&parseFloat(r)<1&&je("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:je("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);je("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Zn){let i=V0[e.toLowerCase()];return i!==void 0?this.setHex(i,t):je("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Es(e.r),this.g=Es(e.g),this.b=Es(e.b),this}copyLinearToSRGB(e){return this.r=Po(e.r),this.g=Po(e.g),this.b=Po(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Zn){return vt.workingToColorSpace(kn.copy(this),e),Math.round(ct(kn.r*255,0,255))*65536+Math.round(ct(kn.g*255,0,255))*256+Math.round(ct(kn.b*255,0,255))}getHexString(e=Zn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=vt.workingColorSpace){vt.workingToColorSpace(kn.copy(this),t);let i=kn.r,s=kn.g,r=kn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=h<=.5?d/(o+a):d/(2-o-a),o){case i:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-i)/d+2;break;case r:l=(i-s)/d+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=vt.workingColorSpace){return vt.workingToColorSpace(kn.copy(this),t),e.r=kn.r,e.g=kn.g,e.b=kn.b,e}getStyle(e=Zn){vt.workingToColorSpace(kn.copy(this),e);let t=kn.r,i=kn.g,s=kn.b;return e!==Zn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Xs),this.setHSL(Xs.h+e,Xs.s+t,Xs.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Xs),e.getHSL(ql);let i=Ma(Xs.h,ql.h,t),s=Ma(Xs.s,ql.s,t),r=Ma(Xs.l,ql.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},kn=new ht;ht.NAMES=V0;var Pa=class extends Ln{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new As,this.environmentIntensity=1,this.environmentRotation=new As,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Fi=new X,Ss=new X,gd=new X,Ms=new X,yo=new X,vo=new X,zg=new X,_d=new X,xd=new X,yd=new X,vd=new Dt,Sd=new Dt,Md=new Dt,Zs=class n{constructor(e=new X,t=new X,i=new X){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Fi.subVectors(e,t),s.cross(Fi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Fi.subVectors(s,t),Ss.subVectors(i,t),gd.subVectors(e,t);let o=Fi.dot(Fi),a=Fi.dot(Ss),l=Fi.dot(gd),c=Ss.dot(Ss),h=Ss.dot(gd),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let u=1/d,m=(c*l-a*h)*u,g=(o*h-a*l)*u;return r.set(1-m-g,g,m)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Ms)===null?!1:Ms.x>=0&&Ms.y>=0&&Ms.x+Ms.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Ms)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ms.x),l.addScaledVector(o,Ms.y),l.addScaledVector(a,Ms.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return vd.setScalar(0),Sd.setScalar(0),Md.setScalar(0),vd.fromBufferAttribute(e,t),Sd.fromBufferAttribute(e,i),Md.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(vd,r.x),o.addScaledVector(Sd,r.y),o.addScaledVector(Md,r.z),o}static isFrontFacing(e,t,i,s){return Fi.subVectors(i,t),Ss.subVectors(e,t),Fi.cross(Ss).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Fi.subVectors(this.c,this.b),Ss.subVectors(this.a,this.b),Fi.cross(Ss).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;yo.subVectors(s,i),vo.subVectors(r,i),_d.subVectors(e,i);let l=yo.dot(_d),c=vo.dot(_d);if(l<=0&&c<=0)return t.copy(i);xd.subVectors(e,s);let h=yo.dot(xd),d=vo.dot(xd);if(h>=0&&d<=h)return t.copy(s);let u=l*d-h*c;if(u<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(i).addScaledVector(yo,o);yd.subVectors(e,r);let m=yo.dot(yd),g=vo.dot(yd);if(g>=0&&m<=g)return t.copy(r);let x=m*c-l*g;if(x<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(i).addScaledVector(vo,a);let f=h*g-m*d;if(f<=0&&d-h>=0&&m-g>=0)return zg.subVectors(r,s),a=(d-h)/(d-h+(m-g)),t.copy(s).addScaledVector(zg,a);let p=1/(f+x+u);return o=x*p,a=u*p,t.copy(i).addScaledVector(yo,o).addScaledVector(vo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},xi=class{constructor(e=new X(1/0,1/0,1/0),t=new X(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Oi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Oi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Oi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Oi):Oi.fromBufferAttribute(r,o),Oi.applyMatrix4(e.matrixWorld),this.expandByPoint(Oi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Yl.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Yl.copy(i.boundingBox)),Yl.applyMatrix4(e.matrixWorld),this.union(Yl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Oi),Oi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ga),$l.subVectors(this.max,ga),So.subVectors(e.a,ga),Mo.subVectors(e.b,ga),bo.subVectors(e.c,ga),qs.subVectors(Mo,So),Ys.subVectors(bo,Mo),Ar.subVectors(So,bo);let t=[0,-qs.z,qs.y,0,-Ys.z,Ys.y,0,-Ar.z,Ar.y,qs.z,0,-qs.x,Ys.z,0,-Ys.x,Ar.z,0,-Ar.x,-qs.y,qs.x,0,-Ys.y,Ys.x,0,-Ar.y,Ar.x,0];return!bd(t,So,Mo,bo,$l)||(t=[1,0,0,0,1,0,0,0,1],!bd(t,So,Mo,bo,$l))?!1:(Zl.crossVectors(qs,Ys),t=[Zl.x,Zl.y,Zl.z],bd(t,So,Mo,bo,$l))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Oi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Oi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(bs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),bs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),bs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),bs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),bs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),bs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),bs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),bs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(bs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},bs=[new X,new X,new X,new X,new X,new X,new X,new X],Oi=new X,Yl=new xi,So=new X,Mo=new X,bo=new X,qs=new X,Ys=new X,Ar=new X,ga=new X,$l=new X,Zl=new X,Rr=new X;function bd(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Rr.fromArray(n,r);let a=s.x*Math.abs(Rr.x)+s.y*Math.abs(Rr.y)+s.z*Math.abs(Rr.z),l=e.dot(Rr),c=t.dot(Rr),h=i.dot(Rr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var mn=new X,jl=new Ke,bS=0,Bi=class extends ki{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:bS++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=uf,this.updateRanges=[],this.gpuType=Hi,this.version=0,this._normalizationScale=e!==void 0?Bh(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)jl.fromBufferAttribute(this,t),jl.applyMatrix3(e),this.setXY(t,jl.x,jl.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)mn.fromBufferAttribute(this,t),mn.applyMatrix3(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)mn.fromBufferAttribute(this,t),mn.applyMatrix4(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)mn.fromBufferAttribute(this,t),mn.applyNormalMatrix(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)mn.fromBufferAttribute(this,t),mn.transformDirection(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):mf(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):gf(e,this.array)}};var Ia=class extends Bi{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var La=class extends Bi{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Ht=class extends Bi{constructor(e,t,i){super(new Float32Array(e),t,i)}},wS=new xi,_a=new X,wd=new X,zi=class{constructor(e=new X,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):wS.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;_a.subVectors(e,this.center);let t=_a.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(_a,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(wd.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(_a.copy(e.center).add(wd)),this.expandByPoint(_a.copy(e.center).sub(wd))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},ES=0,wi=new Ot,Ed=new Ln,wo=new X,mi=new xi,xa=new xi,Cn=new X,ii=class n extends ki{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:ES++}),this.uuid=or(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(jv(e)?La:Ia)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new rt().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return wi.makeRotationFromQuaternion(e),this.applyMatrix4(wi),this}rotateX(e){return wi.makeRotationX(e),this.applyMatrix4(wi),this}rotateY(e){return wi.makeRotationY(e),this.applyMatrix4(wi),this}rotateZ(e){return wi.makeRotationZ(e),this.applyMatrix4(wi),this}translate(e,t,i){return wi.makeTranslation(e,t,i),this.applyMatrix4(wi),this}scale(e,t,i){return wi.makeScale(e,t,i),this.applyMatrix4(wi),this}lookAt(e){return Ed.lookAt(e),Ed.updateMatrix(),this.applyMatrix4(Ed.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(wo).negate(),this.translate(wo.x,wo.y,wo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ht(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&je("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new xi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){it("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new X(-1/0,-1/0,-1/0),new X(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];mi.setFromBufferAttribute(r),this.morphTargetsRelative?(Cn.addVectors(this.boundingBox.min,mi.min),this.boundingBox.expandByPoint(Cn),Cn.addVectors(this.boundingBox.max,mi.max),this.boundingBox.expandByPoint(Cn)):(this.boundingBox.expandByPoint(mi.min),this.boundingBox.expandByPoint(mi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&it('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new zi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){it("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new X,1/0);return}if(e){let i=this.boundingSphere.center;if(mi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];xa.setFromBufferAttribute(a),this.morphTargetsRelative?(Cn.addVectors(mi.min,xa.min),mi.expandByPoint(Cn),Cn.addVectors(mi.max,xa.max),mi.expandByPoint(Cn)):(mi.expandByPoint(xa.min),mi.expandByPoint(xa.max))}mi.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Cn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Cn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Cn.fromBufferAttribute(a,c),l&&(wo.fromBufferAttribute(e,c),Cn.add(wo)),s=Math.max(s,i.distanceToSquared(Cn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&it('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){it("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Bi(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let D=0;D<i.count;D++)a[D]=new X,l[D]=new X;let h=new X,d=new X,u=new X,m=new Ke,g=new Ke,x=new Ke,f=new X,p=new X;function M(D,C,E){c[D]=c[C]=c[E]=1,h.fromBufferAttribute(i,D),d.fromBufferAttribute(i,C),u.fromBufferAttribute(i,E),m.fromBufferAttribute(r,D),g.fromBufferAttribute(r,C),x.fromBufferAttribute(r,E),d.sub(h),u.sub(h),g.sub(m),x.sub(m);let L=1/(g.x*x.y-x.x*g.y);isFinite(L)&&(f.copy(d).multiplyScalar(x.y).addScaledVector(u,-g.y).multiplyScalar(L),p.copy(u).multiplyScalar(g.x).addScaledVector(d,-x.x).multiplyScalar(L),a[D].add(f),a[C].add(f),a[E].add(f),l[D].add(p),l[C].add(p),l[E].add(p))}let P=this.groups;P.length===0&&(P=[{start:0,count:e.count}]);for(let D=0,C=P.length;D<C;++D){let E=P[D],L=E.start,F=E.count;for(let I=L,O=L+F;I<O;I+=3)M(e.getX(I+0),e.getX(I+1),e.getX(I+2))}let y=new X,A=new X,b=new X,_=new X;function v(D){b.fromBufferAttribute(s,D),_.copy(b);let C=a[D];y.copy(C),y.sub(b.multiplyScalar(b.dot(C))).normalize(),A.crossVectors(_,C);let L=A.dot(l[D])<0?-1:1;o.setXYZW(D,y.x,y.y,y.z,L)}for(let D=0,C=i.count;D<C;++D)c[D]&&v(D);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Bi(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let u=0,m=i.count;u<m;u++)i.setXYZ(u,0,0,0);let s=new X,r=new X,o=new X,a=new X,l=new X,c=new X,h=new X,d=new X;if(e)for(let u=0,m=e.count;u<m;u+=3){let g=e.getX(u+0),x=e.getX(u+1),f=e.getX(u+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,x),o.fromBufferAttribute(t,f),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,f),a.add(h),l.add(h),c.add(h),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(f,c.x,c.y,c.z)}else for(let u=0,m=t.count;u<m;u+=3)s.fromBufferAttribute(t,u+0),r.fromBufferAttribute(t,u+1),o.fromBufferAttribute(t,u+2),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),i.setXYZ(u+0,h.x,h.y,h.z),i.setXYZ(u+1,h.x,h.y,h.z),i.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Cn.fromBufferAttribute(e,t),Cn.normalize(),e.setXYZ(t,Cn.x,Cn.y,Cn.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,d=a.normalized,u=new c.constructor(l.length*h),m=0,g=0;for(let x=0,f=l.length;x<f;x++){a.isInterleavedBufferAttribute?m=l[x]*a.data.stride+a.offset:m=l[x]*h;for(let p=0;p<h;p++)u[g++]=c[m++]}return new Bi(u,h,d)}if(this.index===null)return je("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,d=c.length;h<d;h++){let u=c[h],m=e(u,i);l.push(m)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let d=0,u=c.length;d<u;d++){let m=c[d];h.push(m.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],d=r[c];for(let u=0,m=d.length;u<m;u++)h.push(d[u].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Rc=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=uf,this.updateRanges=[],this.version=0,this.uuid=or()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,i){e*=this.stride,i*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[i+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Vg(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let i=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Vg(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function Vg(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=or()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var $n=new X,Vi=class n{constructor(e,t,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=i,this.normalized=s,this._normalizationScale=e!==void 0?Bh(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,i=this.data.count;t<i;t++)$n.fromBufferAttribute(this,t),$n.applyMatrix4(e),this.setXYZ(t,$n.x,$n.y,$n.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)$n.fromBufferAttribute(this,t),$n.applyNormalMatrix(e),this.setXYZ(t,$n.x,$n.y,$n.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)$n.fromBufferAttribute(this,t),$n.transformDirection(e),this.setXYZ(t,$n.x,$n.y,$n.z);return this}getComponent(e,t){let i=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.data.array[e*this.data.stride+this.offset+t]=i,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,i){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.data.array[e+0]=t,this.data.array[e+1]=i,this}setXYZ(e,t,i,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){Aa("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new Bi(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new n(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){Aa("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):mf(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):gf(e,this.data.array)}},Td=new X,TS=new X,AS=new rt,gi=class{constructor(e=new X(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=Td.subVectors(i,t).cross(TS.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(Td),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||AS.getNormalMatrix(e),s=this.coplanarPoint(Td).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},RS=0,rs=class extends ki{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:RS++}),this.uuid=or(),this.name="",this.type="Material",this.blending=Go,this.side=sr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Hd,this.blendDst=Wd,this.blendEquation=Nr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ht(0,0,0),this.blendAlpha=0,this.depthFunc=Io,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=I0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=pc,this.stencilZFail=pc,this.stencilZPass=pc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){je(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){je(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new ht().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new gi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Ke().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ke().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var ws=new X,Ad=new X,Jl=new X,Kl=new X,Ir=class{constructor(e=new X,t=new X(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ws)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ws.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ws.copy(this.origin).addScaledVector(this.direction,t),ws.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Ad.copy(e).add(t).multiplyScalar(.5),Jl.copy(t).sub(e).normalize(),Kl.copy(this.origin).sub(Ad);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Jl),a=Kl.dot(this.direction),l=-Kl.dot(Jl),c=Kl.lengthSq(),h=Math.abs(1-o*o),d,u,m,g;if(h>0)if(d=o*l-a,u=o*a-l,g=r*h,d>=0)if(u>=-g)if(u<=g){let x=1/h;d*=x,u*=x,m=d*(d+o*u+2*a)+u*(o*d+u+2*l)+c}else u=r,d=Math.max(0,-(o*u+a)),m=-d*d+u*(u+2*l)+c;else u=-r,d=Math.max(0,-(o*u+a)),m=-d*d+u*(u+2*l)+c;else u<=-g?(d=Math.max(0,-(-o*r+a)),u=d>0?-r:Math.min(Math.max(-r,-l),r),m=-d*d+u*(u+2*l)+c):u<=g?(d=0,u=Math.min(Math.max(-r,-l),r),m=u*(u+2*l)+c):(d=Math.max(0,-(o*r+a)),u=d>0?r:Math.min(Math.max(-r,-l),r),m=-d*d+u*(u+2*l)+c);else u=o>0?-r:r,d=Math.max(0,-(o*u+a)),m=-d*d+u*(u+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Ad).addScaledVector(Jl,u),m}intersectSphere(e,t){if(e.radius<0)return null;ws.subVectors(e.center,this.origin);let i=ws.dot(this.direction),s=ws.dot(ws)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return c>=0?(i=(e.min.x-u.x)*c,s=(e.max.x-u.x)*c):(i=(e.max.x-u.x)*c,s=(e.min.x-u.x)*c),h>=0?(r=(e.min.y-u.y)*h,o=(e.max.y-u.y)*h):(r=(e.max.y-u.y)*h,o=(e.min.y-u.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(e.min.z-u.z)*d,l=(e.max.z-u.z)*d):(a=(e.max.z-u.z)*d,l=(e.min.z-u.z)*d),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,ws)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,d=e.x-o.x,u=e.y-o.y,m=e.z-o.z,g=t.x-o.x,x=t.y-o.y,f=t.z-o.z,p=i.x-o.x,M=i.y-o.y,P=i.z-o.z,y=Math.abs(l),A=Math.abs(c),b=Math.abs(h),_,v,D,C,E,L,F,I,O,V,k,K;if(y>=A&&y>=b?(D=l,L=d,O=g,K=p,l>=0?(_=c,v=h,C=u,E=m,F=x,I=f,V=M,k=P):(_=h,v=c,C=m,E=u,F=f,I=x,V=P,k=M)):A>=b?(D=c,L=u,O=x,K=M,c>=0?(_=h,v=l,C=m,E=d,F=f,I=g,V=P,k=p):(_=l,v=h,C=d,E=m,F=g,I=f,V=p,k=P)):(D=h,L=m,O=f,K=P,h>=0?(_=l,v=c,C=d,E=u,F=g,I=x,V=p,k=M):(_=c,v=l,C=u,E=d,F=x,I=g,V=M,k=p)),D===0)return null;let Y=_/D,Z=v/D,te=1/D,le=C-Y*L,ce=E-Z*L,ee=F-Y*O,me=I-Z*O,_e=V-Y*K,oe=k-Z*K,de=_e*me-oe*ee,Ne=le*oe-ce*_e,$e=ee*ce-me*le;if(s){if(de<0||Ne<0||$e<0)return null}else if((de<0||Ne<0||$e<0)&&(de>0||Ne>0||$e>0))return null;let Be=de+Ne+$e;if(Be===0)return null;let st=te*(de*L+Ne*O+$e*K);return(Be>0?st<0:st>0)?null:this.at(st/Be,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Cc=class extends rs{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ht(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new As,this.combine=Xd,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Gg=new Ot,Cr=new Ir,Ql=new zi,Hg=new X,ec=new X,tc=new X,nc=new X,Rd=new X,ic=new X,Wg=new X,sc=new X,zn=class extends Ln{constructor(e=new ii,t=new Cc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){ic.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],d=r[l];h!==0&&(Rd.fromBufferAttribute(d,e),o?ic.addScaledVector(Rd,h):ic.addScaledVector(Rd.sub(t),h))}t.add(ic)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Ql.copy(i.boundingSphere),Ql.applyMatrix4(r),Cr.copy(e.ray).recast(e.near),!(Ql.containsPoint(Cr.origin)===!1&&(Cr.intersectSphere(Ql,Hg)===null||Cr.origin.distanceToSquared(Hg)>(e.far-e.near)**2))&&(Gg.copy(r).invert(),Cr.copy(e.ray).applyMatrix4(Gg),!(i.boundingBox!==null&&Cr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Cr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,d=r.attributes.normal,u=r.groups,m=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,x=u.length;g<x;g++){let f=u[g],p=o[f.materialIndex],M=Math.max(f.start,m.start),P=Math.min(a.count,Math.min(f.start+f.count,m.start+m.count));for(let y=M,A=P;y<A;y+=3){let b=a.getX(y),_=a.getX(y+1),v=a.getX(y+2);s=rc(this,p,e,i,c,h,d,b,_,v),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=f.materialIndex,t.push(s))}}else{let g=Math.max(0,m.start),x=Math.min(a.count,m.start+m.count);for(let f=g,p=x;f<p;f+=3){let M=a.getX(f),P=a.getX(f+1),y=a.getX(f+2);s=rc(this,o,e,i,c,h,d,M,P,y),s&&(s.faceIndex=Math.floor(f/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,x=u.length;g<x;g++){let f=u[g],p=o[f.materialIndex],M=Math.max(f.start,m.start),P=Math.min(l.count,Math.min(f.start+f.count,m.start+m.count));for(let y=M,A=P;y<A;y+=3){let b=y,_=y+1,v=y+2;s=rc(this,p,e,i,c,h,d,b,_,v),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=f.materialIndex,t.push(s))}}else{let g=Math.max(0,m.start),x=Math.min(l.count,m.start+m.count);for(let f=g,p=x;f<p;f+=3){let M=f,P=f+1,y=f+2;s=rc(this,o,e,i,c,h,d,M,P,y),s&&(s.faceIndex=Math.floor(f/3),t.push(s))}}}};function CS(n,e,t,i,s,r,o,a){let l;if(e.side===ti?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===sr,a),l===null)return null;sc.copy(a),sc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(sc);return c<t.near||c>t.far?null:{distance:c,point:sc.clone(),object:n}}function rc(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,ec),n.getVertexPosition(l,tc),n.getVertexPosition(c,nc);let h=CS(n,e,t,i,ec,tc,nc,Wg);if(h){let d=new X;Zs.getBarycoord(Wg,ec,tc,nc,d),s&&(h.uv=Zs.getInterpolatedAttribute(s,a,l,c,d,new Ke)),r&&(h.uv1=Zs.getInterpolatedAttribute(r,a,l,c,d,new Ke)),o&&(h.normal=Zs.getInterpolatedAttribute(o,a,l,c,d,new X),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:l,c,normal:new X,materialIndex:0};Zs.getNormal(ec,tc,nc,u.normal),h.face=u,h.barycoord=d}return h}var Pc=class extends ei{constructor(e=null,t=1,i=1,s,r,o,a,l,c=gn,h=gn,d,u){super(null,o,a,l,c,h,s,r,d,u),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Pr=new zi,PS=new Ke(.5,.5),oc=new X,js=class{constructor(e=new gi,t=new gi,i=new gi,s=new gi,r=new gi,o=new gi){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Ei,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],d=r[5],u=r[6],m=r[7],g=r[8],x=r[9],f=r[10],p=r[11],M=r[12],P=r[13],y=r[14],A=r[15];if(s[0].setComponents(c-o,m-h,p-g,A-M).normalize(),s[1].setComponents(c+o,m+h,p+g,A+M).normalize(),s[2].setComponents(c+a,m+d,p+x,A+P).normalize(),s[3].setComponents(c-a,m-d,p-x,A-P).normalize(),i)s[4].setComponents(l,u,f,y).normalize(),s[5].setComponents(c-l,m-u,p-f,A-y).normalize();else if(s[4].setComponents(c-l,m-u,p-f,A-y).normalize(),t===Ei)s[5].setComponents(c+l,m+u,p+f,A+y).normalize();else if(t===Lo)s[5].setComponents(l,u,f,y).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Pr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Pr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Pr)}intersectsSprite(e){Pr.center.set(0,0,0);let t=PS.distanceTo(e.center);return Pr.radius=.7071067811865476+t,Pr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Pr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(oc.x=s.normal.x>0?e.max.x:e.min.x,oc.y=s.normal.y>0?e.max.y:e.min.y,oc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(oc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Xg=new Ot,Ic=class n{constructor(){this.coordinateSystem=Ei,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Xg.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new js),i[s].setFromProjectionMatrix(Xg,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new js),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Da=class extends rs{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ht(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Lc=new X,Dc=new X,qg=new Ot,ya=new Ir,ac=new zi,Cd=new X,Yg=new X,Nc=class extends Ln{constructor(e=new ii,t=new Da){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Lc.fromBufferAttribute(t,s-1),Dc.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Lc.distanceTo(Dc);e.setAttribute("lineDistance",new Ht(i,1))}else je("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),ac.copy(i.boundingSphere),ac.applyMatrix4(s),ac.radius+=r,e.ray.intersectsSphere(ac)===!1)return;qg.copy(s).invert(),ya.copy(e.ray).applyMatrix4(qg);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=i.index,u=i.attributes.position;if(h!==null){let m=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let x=m,f=g-1;x<f;x+=c){let p=h.getX(x),M=h.getX(x+1),P=lc(this,e,ya,l,p,M,x);P&&t.push(P)}if(this.isLineLoop){let x=h.getX(g-1),f=h.getX(m),p=lc(this,e,ya,l,x,f,g-1);p&&t.push(p)}}else{let m=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let x=m,f=g-1;x<f;x+=c){let p=lc(this,e,ya,l,x,x+1,x);p&&t.push(p)}if(this.isLineLoop){let x=lc(this,e,ya,l,g-1,m,g-1);x&&t.push(x)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function lc(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Lc.fromBufferAttribute(a,s),Dc.fromBufferAttribute(a,r),t.distanceSqToSegment(Lc,Dc,Cd,Yg)>i)return;Cd.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Cd);if(!(c<e.near||c>e.far))return{distance:c,point:Yg.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var $g=new X,Zg=new X,Uc=class extends Nc{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)$g.fromBufferAttribute(t,s),Zg.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+$g.distanceTo(Zg);e.setAttribute("lineDistance",new Ht(i,1))}else je("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Na=class extends ei{constructor(e=[],t=Ur,i,s,r,o,a,l,c,h){super(e,t,i,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},Ua=class extends ei{constructor(e,t,i,s,r,o,a,l,c){super(e,t,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Rs=class extends ei{constructor(e,t,i=Gi,s,r,o,a=gn,l=gn,c,h=Ts,d=1){if(h!==Ts&&h!==Ps)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:e,height:t,depth:d};super(u,s,r,o,a,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Uo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Fa=class extends Rs{constructor(e,t=Gi,i=Ur,s,r,o=gn,a=gn,l,c=Ts){let h={width:e,height:e,depth:1},d=[h,h,h,h,h,h];super(e,e,t,i,s,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Oa=class extends ei{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Js=class n extends ii{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],d=[],u=0,m=0;g("z","y","x",-1,-1,i,t,e,o,r,0),g("z","y","x",1,-1,i,t,-e,o,r,1),g("x","z","y",1,1,e,i,t,s,o,2),g("x","z","y",1,-1,e,i,-t,s,o,3),g("x","y","z",1,-1,e,t,i,s,r,4),g("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Ht(c,3)),this.setAttribute("normal",new Ht(h,3)),this.setAttribute("uv",new Ht(d,2));function g(x,f,p,M,P,y,A,b,_,v,D){let C=y/_,E=A/v,L=y/2,F=A/2,I=b/2,O=_+1,V=v+1,k=0,K=0,Y=new X;for(let Z=0;Z<V;Z++){let te=Z*E-F;for(let le=0;le<O;le++){let ce=le*C-L;Y[x]=ce*M,Y[f]=te*P,Y[p]=I,c.push(Y.x,Y.y,Y.z),Y[x]=0,Y[f]=0,Y[p]=b>0?1:-1,h.push(Y.x,Y.y,Y.z),d.push(le/_),d.push(1-Z/v),k+=1}}for(let Z=0;Z<v;Z++)for(let te=0;te<_;te++){let le=u+te+O*Z,ce=u+te+O*(Z+1),ee=u+(te+1)+O*(Z+1),me=u+(te+1)+O*Z;l.push(le,ce,me),l.push(ce,ee,me),K+=6}a.addGroup(m,K,D),m+=K,u+=k}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Oo=class n extends ii{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],d=[],u=[],m=[],g=0,x=[],f=i/2,p=0;M(),o===!1&&(e>0&&P(!0),t>0&&P(!1)),this.setIndex(h),this.setAttribute("position",new Ht(d,3)),this.setAttribute("normal",new Ht(u,3)),this.setAttribute("uv",new Ht(m,2));function M(){let y=new X,A=new X,b=0,_=(t-e)/i;for(let v=0;v<=r;v++){let D=[],C=v/r,E=C*(t-e)+e;for(let L=0;L<=s;L++){let F=L/s,I=F*l+a,O=Math.sin(I),V=Math.cos(I);A.x=E*O,A.y=-C*i+f,A.z=E*V,d.push(A.x,A.y,A.z),y.set(O,_,V).normalize(),u.push(y.x,y.y,y.z),m.push(F,1-C),D.push(g++)}x.push(D)}for(let v=0;v<s;v++)for(let D=0;D<r;D++){let C=x[D][v],E=x[D+1][v],L=x[D+1][v+1],F=x[D][v+1];(e>0||D!==0)&&(h.push(C,E,F),b+=3),(t>0||D!==r-1)&&(h.push(E,L,F),b+=3)}c.addGroup(p,b,0),p+=b}function P(y){let A=g,b=new Ke,_=new X,v=0,D=y===!0?e:t,C=y===!0?1:-1;for(let L=1;L<=s;L++)d.push(0,f*C,0),u.push(0,C,0),m.push(.5,.5),g++;let E=g;for(let L=0;L<=s;L++){let I=L/s*l+a,O=Math.cos(I),V=Math.sin(I);_.x=D*V,_.y=f*C,_.z=D*O,d.push(_.x,_.y,_.z),u.push(0,C,0),b.x=O*.5+.5,b.y=V*.5*C+.5,m.push(b.x,b.y),g++}for(let L=0;L<s;L++){let F=A+L,I=E+L;y===!0?h.push(I,I+1,F):h.push(I+1,I,F),v+=3}c.addGroup(p,v,y===!0?1:2),p+=v}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Ba=class n extends Oo{constructor(e=1,t=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Lr=class n extends ii{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,h=l+1,d=e/a,u=t/l,m=[],g=[],x=[],f=[];for(let p=0;p<h;p++){let M=p*u-o;for(let P=0;P<c;P++){let y=P*d-r;g.push(y,-M,0),x.push(0,0,1),f.push(P/a),f.push(1-p/l)}}for(let p=0;p<l;p++)for(let M=0;M<a;M++){let P=M+c*p,y=M+c*(p+1),A=M+1+c*(p+1),b=M+1+c*p;m.push(P,y,b),m.push(y,A,b)}this.setIndex(m),this.setAttribute("position",new Ht(g,3)),this.setAttribute("normal",new Ht(x,3)),this.setAttribute("uv",new Ht(f,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var ka=class n extends ii{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,h=[],d=new X,u=new X,m=[],g=[],x=[],f=[];for(let p=0;p<=i;p++){let M=[],P=p/i,y=o+P*a,A=e*Math.cos(y),b=Math.sqrt(e*e-A*A),_=0;p===0&&o===0?_=.5/t:p===i&&l===Math.PI&&(_=-.5/t);for(let v=0;v<=t;v++){let D=v/t,C=s+D*r;d.x=-b*Math.cos(C),d.y=A,d.z=b*Math.sin(C),g.push(d.x,d.y,d.z),u.copy(d).normalize(),x.push(u.x,u.y,u.z),f.push(D+_,1-P),M.push(c++)}h.push(M)}for(let p=0;p<i;p++)for(let M=0;M<t;M++){let P=h[p][M+1],y=h[p][M],A=h[p+1][M],b=h[p+1][M+1];(p!==0||o>0)&&m.push(P,y,b),(p!==i-1||l<Math.PI)&&m.push(y,A,b)}this.setIndex(m),this.setAttribute("position",new Ht(g,3)),this.setAttribute("normal",new Ht(x,3)),this.setAttribute("uv",new Ht(f,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var za=class extends ii{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],i=new Set,s=new X,r=new X;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,h=l.length;c<h;++c){let d=l[c],u=d.start,m=d.count;for(let g=u,x=u+m;g<x;g+=3)for(let f=0;f<3;f++){let p=a.getX(g+f),M=a.getX(g+(f+1)%3);s.fromBufferAttribute(o,p),r.fromBufferAttribute(o,M),jg(s,r,i)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let h=3*a+c,d=3*a+(c+1)%3;s.fromBufferAttribute(o,h),r.fromBufferAttribute(o,d),jg(s,r,i)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new Ht(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function jg(n,e,t){let i=`${n.x},${n.y},${n.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${n.x},${n.y},${n.z}`;return t.has(i)===!0||t.has(s)===!0?!1:(t.add(i),t.add(s),!0)}var Va=class extends rs{constructor(e){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new ht(0),this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.fog=e.fog,this}};function Or(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(Jg(s))s.isRenderTargetTexture?(je("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(Jg(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Vn(n){let e={};for(let t=0;t<n.length;t++){let i=Or(n[t]);for(let s in i)e[s]=i[s]}return e}function Jg(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function IS(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function _f(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:vt.workingColorSpace}var al={clone:Or,merge:Vn},LS=`void main() {
gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,DS=`void main() {
gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ti=class extends rs{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=LS,this.fragmentShader=DS,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Or(e.uniforms),this.uniformsGroups=IS(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new ht().setHex(s.value);break;case"v2":this.uniforms[i].value=new Ke().fromArray(s.value);break;case"v3":this.uniforms[i].value=new X().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Dt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new rt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Ot().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Fc=class extends Ti{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Bo=class extends rs{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new ht(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ht(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Oh,this.normalScale=new Ke(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new As,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var Oc=class extends rs{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=C0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Bc=class extends rs{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Eo(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function cc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Ks=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break e}o=i,i=0;break t}break n}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},kc=class extends Ks{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Dd,endingEnd:Dd}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Nd:r=e,a=2*t-i;break;case Ud:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Nd:o=e,l=2*i-t;break;case Ud:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,m=this._weightNext,g=(i-t)/(s-t),x=g*g,f=x*g,p=-u*f+2*u*x-u*g,M=(1+u)*f+(-1.5-2*u)*x+(-.5+u)*g+1,P=(-1-m)*f+(1.5+m)*x+.5*g,y=m*f-m*x;for(let A=0;A!==a;++A)r[A]=p*o[h+A]+M*o[c+A]+P*o[l+A]+y*o[d+A];return r}},zc=class extends Ks{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(i-t)/(s-t),d=1-h;for(let u=0;u!==a;++u)r[u]=o[c+u]*d+o[l+u]*h;return r}},Vc=class extends Ks{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Gc=class extends Ks{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,d=this.outTangents;if(!h||!d){let g=(i-t)/(s-t),x=1-g;for(let f=0;f!==a;++f)r[f]=o[c+f]*x+o[l+f]*g;return r}let u=a*2,m=e-1;for(let g=0;g!==a;++g){let x=o[c+g],f=o[l+g],p=m*u+g*2,M=d[p],P=d[p+1],y=e*u+g*2,A=h[y],b=h[y+1],_=US(i,t,M,A,s);r[g]=G0(_,x,P,b,f)}return r}};function G0(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function NS(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function US(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=G0(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=NS(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var yi=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Eo(t,this.TimeBufferType),this.values=Eo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Eo(e.times,Array),values:Eo(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),cc(e.settings)&&(i.settings={inTangents:Eo(e.settings.inTangents,Array),outTangents:Eo(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Vc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new zc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new kc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Gc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case ba:t=this.InterpolantFactoryMethodDiscrete;break;case wc:t=this.InterpolantFactoryMethodLinear;break;case fc:t=this.InterpolantFactoryMethodSmooth;break;case Ld:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return je("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ba;case this.InterpolantFactoryMethodLinear:return wc;case this.InterpolantFactoryMethodSmooth:return fc;case this.InterpolantFactoryMethodBezier:return Ld}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;cc(this.settings)&&(Kg(this.settings.inTangents,e),Kg(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;cc(this.settings)&&(Qg(this.settings.inTangents,e),Qg(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(it("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(it("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){it("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){it("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&Jv(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){it("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===fc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let d=a*i,u=d-i,m=d+i;for(let g=0;g!==i;++g){let x=t[d+g];if(x!==t[u+g]||x!==t[m+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let d=a*i,u=o*i;for(let m=0;m!==i;++m)t[u+m]=t[d+m]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,cc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Kg(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function Qg(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}yi.prototype.ValueTypeName="";yi.prototype.TimeBufferType=Float32Array;yi.prototype.ValueBufferType=Float32Array;yi.prototype.DefaultInterpolation=wc;var Qs=class extends yi{constructor(e,t,i){super(e,t,i)}};Qs.prototype.ValueTypeName="bool";Qs.prototype.ValueBufferType=Array;Qs.prototype.DefaultInterpolation=ba;Qs.prototype.InterpolantFactoryMethodLinear=void 0;Qs.prototype.InterpolantFactoryMethodSmooth=void 0;var Hc=class extends yi{constructor(e,t,i,s){super(e,t,i,s)}};Hc.prototype.ValueTypeName="color";var Wc=class extends yi{constructor(e,t,i,s){super(e,t,i,s)}};Wc.prototype.ValueTypeName="number";var Xc=class extends Ks{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)Qn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ga=class extends yi{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new Xc(this.times,this.values,this.getValueSize(),e)}};Ga.prototype.ValueTypeName="quaternion";Ga.prototype.InterpolantFactoryMethodSmooth=void 0;var er=class extends yi{constructor(e,t,i){super(e,t,i)}};er.prototype.ValueTypeName="string";er.prototype.ValueBufferType=Array;er.prototype.DefaultInterpolation=ba;er.prototype.InterpolantFactoryMethodLinear=void 0;er.prototype.InterpolantFactoryMethodSmooth=void 0;var qc=class extends yi{constructor(e,t,i,s){super(e,t,i,s)}};qc.prototype.ValueTypeName="vector";var Yc=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,d){return c.push(h,d),this},this.removeHandler=function(h){let d=c.indexOf(h);return d!==-1&&c.splice(d,2),this},this.getHandler=function(h){for(let d=0,u=c.length;d<u;d+=2){let m=c[d],g=c[d+1];if(m.global&&(m.lastIndex=0),m.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},H0=new Yc,$c=class{constructor(e){this.manager=e!==void 0?e:H0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};$c.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ha=class extends Ln{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ht(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Wa=class extends Ha{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Ln.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ht(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},Pd=new Ot,e0=new X,t0=new X,Zc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ke(512,512),this.mapType=si,this.map=null,this.mapPass=null,this.matrix=new Ot,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new js,this._frameExtents=new Ke(1,1),this._viewportCount=1,this._viewports=[new Dt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;e0.setFromMatrixPosition(e.matrixWorld),t.position.copy(e0),t0.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(t0),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){Pd.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(Pd,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Lo||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Pd)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},hc=new X,uc=new Qn,is=new X,Xa=class extends Ln{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ot,this.projectionMatrix=new Ot,this.projectionMatrixInverse=new Ot,this.coordinateSystem=Ei,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(hc,uc,is),is.x===1&&is.y===1&&is.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(hc,uc,is.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(hc,uc,is),is.x===1&&is.y===1&&is.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(hc,uc,is.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},$s=new X,n0=new Ke,i0=new Ke,jn=class extends Xa{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=No*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Sa*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return No*2*Math.atan(Math.tan(Sa*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){$s.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set($s.x,$s.y).multiplyScalar(-e/$s.z),$s.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set($s.x,$s.y).multiplyScalar(-e/$s.z)}getViewSize(e,t){return this.getViewBounds(e,n0,i0),t.subVectors(i0,n0)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Sa*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var qa=class extends Xa{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Fd=class extends Zc{constructor(){super(new qa(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Ya=class extends Ha{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Ln.DEFAULT_UP),this.updateMatrix(),this.target=new Ln,this.shadow=new Fd}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var $a=class extends ii{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var To=-90,Ao=1,ko=class extends Ln{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new jn(To,Ao,e,t);s.layers=this.layers,this.add(s);let r=new jn(To,Ao,e,t);r.layers=this.layers,this.add(r);let o=new jn(To,Ao,e,t);o.layers=this.layers,this.add(o);let a=new jn(To,Ao,e,t);a.layers=this.layers,this.add(a);let l=new jn(To,Ao,e,t);l.layers=this.layers,this.add(l);let c=new jn(To,Ao,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ei)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Lo)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,d=e.getRenderTarget(),u=e.getActiveCubeFace(),m=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let f=!1;e.isWebGLRenderer===!0?f=e.state.buffers.depth.getReversed():f=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=x,e.setRenderTarget(i,5,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(d,u,m),e.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},jc=class extends jn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var xf="\\[\\]\\.:\\/",FS=new RegExp("["+xf+"]","g"),yf="[^"+xf+"]",OS="[^"+xf.replace("\\.","")+"]",BS=/((?:WC+[\/:])*)/.source.replace("WC",yf),kS=/(WCOD+)?/.source.replace("WCOD",OS),zS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",yf),VS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",yf),GS=new RegExp("^"+BS+kS+zS+VS+"$"),HS=["material","materials","bones","map"],Od=class{constructor(e,t,i){let s=i||Zt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Zt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(FS,"")}static parseTrackName(e){let t=GS.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);HS.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){je("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){it("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){it("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){it("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){it("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){it("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){it("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){it("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;it("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){it("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){it("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Zt.Composite=Od;Zt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Zt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Zt.prototype.GetterByBindingType=[Zt.prototype._getValue_direct,Zt.prototype._getValue_array,Zt.prototype._getValue_arrayElement,Zt.prototype._getValue_toArray];Zt.prototype.SetterByBindingTypeAndVersioning=[[Zt.prototype._setValue_direct,Zt.prototype._setValue_direct_setNeedsUpdate,Zt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_array,Zt.prototype._setValue_array_setNeedsUpdate,Zt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_arrayElement,Zt.prototype._setValue_arrayElement_setNeedsUpdate,Zt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_fromArray,Zt.prototype._setValue_fromArray_setNeedsUpdate,Zt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var nR=new Float32Array(1);var tr=class extends Rc{constructor(e,t,i=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=i}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var zo=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=ct(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(ct(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Ef=class Ef{constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};Ef.prototype.isMatrix2=!0;var Bd=Ef;var s0=new X,dc=new X,Ro=new X,Co=new X,Id=new X,WS=new X,XS=new X,Za=class{constructor(e=new X,t=new X){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){s0.subVectors(e,this.start),dc.subVectors(this.end,this.start);let i=dc.dot(dc);if(i===0)return 0;let r=dc.dot(s0)/i;return t&&(r=ct(r,0,1)),r}closestPointToPoint(e,t,i){let s=this.closestPointToPointParameter(e,t);return this.delta(i).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=WS,i=XS){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,h=e.end;Ro.subVectors(c,a),Co.subVectors(h,l),Id.subVectors(a,l);let d=Ro.dot(Ro),u=Co.dot(Co),m=Co.dot(Id);if(d<=s&&u<=s)return t.copy(a),i.copy(l),t.distanceToSquared(i);if(d<=s)r=0,o=m/u,o=ct(o,0,1);else{let g=Ro.dot(Id);if(u<=s)o=0,r=ct(-g/d,0,1);else{let x=Ro.dot(Co),f=d*u-x*x;f!==0?r=ct((x*m-g*u)/f,0,1):r=0,o=(x*r+m)/u,o<0?(o=0,r=ct(-g/d,0,1)):o>1&&(o=1,r=ct((x-g)/d,0,1))}}return t.copy(a).addScaledVector(Ro,r),i.copy(l).addScaledVector(Co,o),t.distanceToSquared(i)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var ja=class extends Uc{constructor(e=10,t=10,i=4473924,s=8947848){i=new ht(i),s=new ht(s);let r=t/2,o=e/t,a=e/2,l=[],c=[];for(let u=0,m=0,g=-a;u<=t;u++,g+=o){l.push(-a,0,g,a,0,g),l.push(g,0,-a,g,0,a);let x=u===r?i:s;x.toArray(c,m),m+=3,x.toArray(c,m),m+=3,x.toArray(c,m),m+=3,x.toArray(c,m),m+=3}let h=new ii;h.setAttribute("position",new Ht(l,3)),h.setAttribute("color",new Ht(c,3));let d=new Da({vertexColors:!0,toneMapped:!1});super(h,d),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var Ja=class extends ki{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function vf(n,e,t,i){let s=qS(i);switch(t){case rf:return n*e;case af:return n*e/s.components*s.byteLength;case sh:return n*e/s.components*s.byteLength;case rr:return n*e*2/s.components*s.byteLength;case rh:return n*e*2/s.components*s.byteLength;case of:return n*e*3/s.components*s.byteLength;case Xi:return n*e*4/s.components*s.byteLength;case oh:return n*e*4/s.components*s.byteLength;case el:case tl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case nl:case il:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case lh:case hh:return Math.max(n,16)*Math.max(e,8)/4;case ah:case ch:return Math.max(n,8)*Math.max(e,8)/2;case uh:case dh:case ph:case mh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case fh:case sl:case gh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case _h:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case xh:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case yh:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case vh:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Sh:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Mh:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case bh:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case wh:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Eh:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Th:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Ah:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Rh:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Ch:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Ph:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Ih:case Lh:case Dh:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Nh:case Uh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case rl:case Fh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function qS(n){switch(n){case si:case ef:return{byteLength:1,components:1};case Wo:case tf:case Wi:return{byteLength:2,components:1};case nh:case ih:return{byteLength:2,components:4};case Gi:case th:case Hi:return{byteLength:4,components:1};case nf:case sf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?je("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function u_(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function $S(n){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,d=c.byteLength,u=n.createBuffer();n.bindBuffer(l,u),n.bufferData(l,c,h),a.onUploadCallback();let m;if(c instanceof Float32Array)m=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)m=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?m=n.HALF_FLOAT:m=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)m=n.SHORT;else if(c instanceof Uint32Array)m=n.UNSIGNED_INT;else if(c instanceof Int32Array)m=n.INT;else if(c instanceof Int8Array)m=n.BYTE;else if(c instanceof Uint8Array)m=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)m=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:m,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function i(a,l,c){let h=l.array,d=l.updateRanges;if(n.bindBuffer(c,a),d.length===0)n.bufferSubData(c,0,h);else{d.sort((m,g)=>m.start-g.start);let u=0;for(let m=1;m<d.length;m++){let g=d[u],x=d[m];x.start<=g.start+g.count+1?g.count=Math.max(g.count,x.start+x.count-g.start):(++u,d[u]=x)}d.length=u+1;for(let m=0,g=d.length;m<g;m++){let x=d[m];n.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var ZS=`#ifdef USE_ALPHAHASH
if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,jS=`#ifdef USE_ALPHAHASH
const float ALPHA_HASH_SCALE = 0.05;
float hash2D( vec2 value ) {
return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
}
float hash3D( vec3 value ) {
return hash2D( vec2( hash2D( value.xy ), value.z ) );
}
float getAlphaHashThreshold( vec3 position ) {
float maxDeriv = max(
length( dFdx( position.xyz ) ),
length( dFdy( position.xyz ) )
);
float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
vec2 pixScales = vec2(
exp2( floor( log2( pixScale ) ) ),
exp2( ceil( log2( pixScale ) ) )
);
vec2 alpha = vec2(
hash3D( floor( pixScales.x * position.xyz ) ),
hash3D( floor( pixScales.y * position.xyz ) )
);
float lerpFactor = fract( log2( pixScale ) );
float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
float a = min( lerpFactor, 1.0 - lerpFactor );
vec3 cases = vec3(
x * x / ( 2.0 * a * ( 1.0 - a ) ),
( x - 0.5 * a ) / ( 1.0 - a ),
1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
);
float threshold = ( x < ( 1.0 - a ) )
? ( ( x < a ) ? cases.x : cases.y )
: cases.z;
return clamp( threshold , 1.0e-6, 1.0 );
}
#endif`,JS=`#ifdef USE_ALPHAMAP
diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,KS=`#ifdef USE_ALPHAMAP
uniform sampler2D alphaMap;
#endif`,QS=`#ifdef USE_ALPHATEST
#ifdef ALPHA_TO_COVERAGE
diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
if ( diffuseColor.a == 0.0 ) discard;
#else
if ( diffuseColor.a < alphaTest ) discard;
#endif
#endif`,eM=`#ifdef USE_ALPHATEST
uniform float alphaTest;
#endif`,tM=`#ifdef USE_AOMAP
float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
reflectedLight.indirectDiffuse *= ambientOcclusion;
#if defined( USE_CLEARCOAT ) 
clearcoatSpecularIndirect *= ambientOcclusion;
#endif
#if defined( USE_SHEEN ) 
sheenSpecularIndirect *= ambientOcclusion;
#endif
#if defined( USE_ENVMAP ) && defined( STANDARD )
float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
#endif
#endif`,nM=`#ifdef USE_AOMAP
uniform sampler2D aoMap;
uniform float aoMapIntensity;
#endif`,iM=`#ifdef USE_BATCHING
#if ! defined( GL_ANGLE_multi_draw )
#define gl_DrawID _gl_DrawID
uniform int _gl_DrawID;
#endif
uniform highp sampler2D batchingTexture;
uniform highp usampler2D batchingIdTexture;
mat4 getBatchingMatrix( const in float i ) {
int size = textureSize( batchingTexture, 0 ).x;
int j = int( i ) * 4;
int x = j % size;
int y = j / size;
vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
return mat4( v1, v2, v3, v4 );
}
float getIndirectIndex( const in int i ) {
int size = textureSize( batchingIdTexture, 0 ).x;
int x = i % size;
int y = i / size;
return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
}
#endif
#ifdef USE_BATCHING_COLOR
uniform sampler2D batchingColorTexture;
vec4 getBatchingColor( const in float i ) {
int size = textureSize( batchingColorTexture, 0 ).x;
int j = int( i );
int x = j % size;
int y = j / size;
return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
}
#endif`,sM=`#ifdef USE_BATCHING
mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,rM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
vPosition = vec3( position );
#endif`,oM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
vec3 objectTangent = vec3( tangent.xyz );
#endif`,aM=`float G_BlinnPhong_Implicit( ) {
return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
vec3 halfDir = normalize( lightDir + viewDir );
float dotNH = saturate( dot( normal, halfDir ) );
float dotVH = saturate( dot( viewDir, halfDir ) );
vec3 F = F_Schlick( specularColor, 1.0, dotVH );
float G = G_BlinnPhong_Implicit( );
float D = D_BlinnPhong( shininess, dotNH );
return F * ( G * D );
} // validated`,lM=`#ifdef USE_IRIDESCENCE
const mat3 XYZ_TO_REC709 = mat3(
 3.2404542, -0.9692660,  0.0556434,
-1.5371385,  1.8760108, -0.2040259,
-0.4985314,  0.0415560,  1.0572252
);
vec3 Fresnel0ToIor( vec3 fresnel0 ) {
vec3 sqrtF0 = sqrt( fresnel0 );
return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
}
vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
}
float IorToFresnel0( float transmittedIor, float incidentIor ) {
return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
}
vec3 evalSensitivity( float OPD, vec3 shift ) {
float phase = 2.0 * PI * OPD * 1.0e-9;
vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
xyz /= 1.0685e-7;
vec3 rgb = XYZ_TO_REC709 * xyz;
return rgb;
}
vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
vec3 I;
float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
float cosTheta2Sq = 1.0 - sinTheta2Sq;
if ( cosTheta2Sq < 0.0 ) {
return vec3( 1.0 );
}
float cosTheta2 = sqrt( cosTheta2Sq );
float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
float R12 = F_Schlick( R0, 1.0, cosTheta1 );
float T121 = 1.0 - R12;
float phi12 = 0.0;
if ( iridescenceIOR < outsideIOR ) phi12 = PI;
float phi21 = PI - phi12;
vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
vec3 phi23 = vec3( 0.0 );
if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
vec3 phi = vec3( phi21 ) + phi23;
vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
vec3 r123 = sqrt( R123 );
vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
vec3 C0 = R12 + Rs;
I = C0;
vec3 Cm = Rs - T121;
for ( int m = 1; m <= 2; ++ m ) {
Cm *= r123;
vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
I += Cm * Sm;
}
return max( I, vec3( 0.0 ) );
}
#endif`,cM=`#ifdef USE_BUMPMAP
uniform sampler2D bumpMap;
uniform float bumpScale;
vec2 dHdxy_fwd() {
vec2 dSTdx = dFdx( vBumpMapUv );
vec2 dSTdy = dFdy( vBumpMapUv );
float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
return vec2( dBx, dBy );
}
vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
vec3 vN = surf_norm;
vec3 R1 = cross( vSigmaY, vN );
vec3 R2 = cross( vN, vSigmaX );
float fDet = dot( vSigmaX, R1 ) * faceDirection;
vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
return normalize( abs( fDet ) * surf_norm - vGrad );
}
#endif`,hM=`#if NUM_CLIPPING_PLANES > 0
vec4 plane;
#ifdef ALPHA_TO_COVERAGE
float distanceToPlane, distanceGradient;
float clipOpacity = 1.0;
#pragma unroll_loop_start
for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
plane = clippingPlanes[ i ];
distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
distanceGradient = fwidth( distanceToPlane ) / 2.0;
clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
if ( clipOpacity == 0.0 ) discard;
}
#pragma unroll_loop_end
#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
float unionClipOpacity = 1.0;
#pragma unroll_loop_start
for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
plane = clippingPlanes[ i ];
distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
distanceGradient = fwidth( distanceToPlane ) / 2.0;
unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
}
#pragma unroll_loop_end
clipOpacity *= 1.0 - unionClipOpacity;
#endif
diffuseColor.a *= clipOpacity;
if ( diffuseColor.a == 0.0 ) discard;
#else
#pragma unroll_loop_start
for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
plane = clippingPlanes[ i ];
if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
}
#pragma unroll_loop_end
#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
bool clipped = true;
#pragma unroll_loop_start
for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
plane = clippingPlanes[ i ];
clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
}
#pragma unroll_loop_end
if ( clipped ) discard;
#endif
#endif
#endif`,uM=`#if NUM_CLIPPING_PLANES > 0
varying vec3 vClipPosition;
uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,dM=`#if NUM_CLIPPING_PLANES > 0
varying vec3 vClipPosition;
#endif`,fM=`#if NUM_CLIPPING_PLANES > 0
vClipPosition = - mvPosition.xyz;
#endif`,pM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
diffuseColor *= vColor;
#endif`,mM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
varying vec4 vColor;
#endif`,gM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
varying vec4 vColor;
#endif`,_M=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
vColor *= color;
#elif defined( USE_COLOR )
vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,xM=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
const highp float a = 12.9898, b = 78.233, c = 43758.5453;
highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
float precisionSafeLength( vec3 v ) { return length( v ); }
#else
float precisionSafeLength( vec3 v ) {
float maxComponent = max3( abs( v ) );
return length( v / maxComponent ) * maxComponent;
}
#endif
struct IncidentLight {
vec3 color;
vec3 direction;
bool visible;
};
struct ReflectedLight {
vec3 directDiffuse;
vec3 directSpecular;
vec3 indirectDiffuse;
vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,yM=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
mat3 bm = mat3( batchingMatrix );
transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
transformedNormal = bm * transformedNormal;
#ifdef USE_TANGENT
transformedTangent = bm * transformedTangent;
#endif
#endif
#ifdef USE_INSTANCING
mat3 im = mat3( instanceMatrix );
transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
transformedNormal = im * transformedNormal;
#ifdef USE_TANGENT
transformedTangent = im * transformedTangent;
#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,vM=`#ifdef USE_DISPLACEMENTMAP
uniform sampler2D displacementMap;
uniform float displacementScale;
uniform float displacementBias;
#endif`,SM=`#ifdef USE_DISPLACEMENTMAP
transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,MM=`#ifdef USE_EMISSIVEMAP
vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
emissiveColor = sRGBTransferEOTF( emissiveColor );
#endif
totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,bM=`#ifdef USE_EMISSIVEMAP
uniform sampler2D emissiveMap;
#endif`,wM="gl_FragColor = linearToOutputTexel( gl_FragColor );",EM=`vec4 LinearTransferOETF( in vec4 value ) {
return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,TM=`#ifdef USE_ENVMAP
#ifdef ENV_WORLDPOS
vec3 cameraToFrag;
if ( isOrthographic ) {
cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
} else {
cameraToFrag = normalize( vWorldPosition - cameraPosition );
}
vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
#ifdef ENVMAP_MODE_REFLECTION
vec3 reflectVec = reflect( cameraToFrag, worldNormal );
#else
vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
#endif
#else
vec3 reflectVec = vReflect;
#endif
#ifdef ENVMAP_TYPE_CUBE
vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
#ifdef ENVMAP_BLENDING_MULTIPLY
outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
#elif defined( ENVMAP_BLENDING_MIX )
outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
#elif defined( ENVMAP_BLENDING_ADD )
outgoingLight += envColor.xyz * specularStrength * reflectivity;
#endif
#endif
#endif`,AM=`#ifdef USE_ENVMAP
uniform float envMapIntensity;
uniform mat3 envMapRotation;
uniform samplerCube envMap;
#ifdef ENVMAP_TYPE_PMREM
float roughnessToMip( const in float roughness ) {
float r = clamp( roughness, 0.0, 1.0 );
return ENVMAP_MAX_LOD * r * ( 2.0 - r );
}
#endif
#endif`,RM=`#ifdef USE_ENVMAP
uniform float reflectivity;
#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
#define ENV_WORLDPOS
#endif
#ifdef ENV_WORLDPOS
varying vec3 vWorldPosition;
uniform float refractionRatio;
#else
varying vec3 vReflect;
#endif
#endif`,CM=`#ifdef USE_ENVMAP
#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
#define ENV_WORLDPOS
#endif
#ifdef ENV_WORLDPOS

varying vec3 vWorldPosition;
#else
varying vec3 vReflect;
uniform float refractionRatio;
#endif
#endif`,PM=`#ifdef USE_ENVMAP
#ifdef ENV_WORLDPOS
vWorldPosition = worldPosition.xyz;
#else
vec3 cameraToVertex;
if ( isOrthographic ) {
cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
} else {
cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
}
vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
#ifdef ENVMAP_MODE_REFLECTION
vReflect = reflect( cameraToVertex, worldNormal );
#else
vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
#endif
#endif
#endif`,IM=`#ifdef USE_FOG
vFogDepth = - mvPosition.z;
#endif`,LM=`#ifdef USE_FOG
varying float vFogDepth;
#endif`,DM=`#ifdef USE_FOG
#ifdef FOG_EXP2
float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
#else
float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
#endif
gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,NM=`#ifdef USE_FOG
uniform vec3 fogColor;
varying float vFogDepth;
#ifdef FOG_EXP2
uniform float fogDensity;
#else
uniform float fogNear;
uniform float fogFar;
#endif
#endif`,UM=`#ifdef USE_GRADIENTMAP
uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
float dotNL = dot( normal, lightDirection );
vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
#ifdef USE_GRADIENTMAP
return vec3( texture2D( gradientMap, coord ).r );
#else
vec2 fw = fwidth( coord ) * 0.5;
return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
#endif
}`,FM=`#ifdef USE_LIGHTMAP
uniform sampler2D lightMap;
uniform float lightMapIntensity;
#endif`,OM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,BM=`varying vec3 vViewPosition;
struct LambertMaterial {
vec3 diffuseColor;
float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
vec3 irradiance = dotNL * directLight.color;
reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,kM=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
float x = normal.x, y = normal.y, z = normal.z;
vec3 result = shCoefficients[ 0 ] * 0.886227;
result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
vec3 irradiance = ambientLightColor;
return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
if ( cutoffDistance > 0.0 ) {
distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
}
return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
struct SunLight {
vec3 direction;
vec3 color;
};
uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
light.color = sunLight.color;
light.direction = sunLight.direction;
light.visible = true;
}
#endif
#if NUM_DIR_LIGHTS > 0
struct DirectionalLight {
vec3 direction;
vec3 color;
};
uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
light.color = directionalLight.color;
light.direction = directionalLight.direction;
light.visible = true;
}
#endif
#if NUM_POINT_LIGHTS > 0
struct PointLight {
vec3 position;
vec3 color;
float distance;
float decay;
};
uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
vec3 lVector = pointLight.position - geometryPosition;
light.direction = normalize( lVector );
float lightDistance = length( lVector );
light.color = pointLight.color;
light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
light.visible = ( light.color != vec3( 0.0 ) );
}
#endif
#if NUM_SPOT_LIGHTS > 0
struct SpotLight {
vec3 position;
vec3 direction;
vec3 color;
float distance;
float decay;
float coneCos;
float penumbraCos;
};
uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
vec3 lVector = spotLight.position - geometryPosition;
light.direction = normalize( lVector );
float angleCos = dot( light.direction, spotLight.direction );
float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
if ( spotAttenuation > 0.0 ) {
float lightDistance = length( lVector );
light.color = spotLight.color * spotAttenuation;
light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
light.visible = ( light.color != vec3( 0.0 ) );
} else {
light.color = vec3( 0.0 );
light.visible = false;
}
}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
struct RectAreaLight {
vec3 color;
vec3 position;
vec3 halfWidth;
vec3 halfHeight;
};
uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
struct HemisphereLight {
vec3 direction;
vec3 skyColor;
vec3 groundColor;
};
uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
float dotNL = dot( normal, hemiLight.direction );
float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
return irradiance;
}
#endif
#include <lightprobes_pars_fragment>`,zM=`#ifdef USE_ENVMAP
vec3 getIBLIrradiance( const in vec3 normal ) {
#ifdef ENVMAP_TYPE_PMREM
vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
return PI * envMapColor.rgb * envMapIntensity;
#else
return vec3( 0.0 );
#endif
}
vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
#ifdef ENVMAP_TYPE_PMREM
vec3 reflectVec = reflect( - viewDir, normal );
reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
return envMapColor.rgb * envMapIntensity;
#else
return vec3( 0.0 );
#endif
}
#ifdef USE_RETROREFLECTION
vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
#ifdef ENVMAP_TYPE_PMREM
vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
return envMapColor.rgb * envMapIntensity;
#else
return vec3( 0.0 );
#endif
}
#endif
#ifdef USE_ANISOTROPY
vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
#ifdef ENVMAP_TYPE_PMREM
vec3 bentNormal = cross( bitangent, viewDir );
bentNormal = normalize( cross( bentNormal, bitangent ) );
bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
return getIBLRadiance( viewDir, bentNormal, roughness );
#else
return vec3( 0.0 );
#endif
}
#ifdef USE_RETROREFLECTION
vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
#ifdef ENVMAP_TYPE_PMREM
vec3 bentNormal = cross( bitangent, viewDir );
bentNormal = normalize( cross( bentNormal, bitangent ) );
bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
return getIBLRetroRadiance( viewDir, bentNormal, roughness );
#else
return vec3( 0.0 );
#endif
}
#endif
#endif
#endif`,VM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,GM=`varying vec3 vViewPosition;
struct ToonMaterial {
vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,HM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,WM=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
vec3 diffuseColor;
vec3 specularColor;
float specularShininess;
float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
vec3 irradiance = dotNL * directLight.color;
reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,XM=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
float diffuseRoughnessFactor = diffuseRoughness;
#ifdef USE_DIFFUSE_ROUGHNESSMAP
diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
#endif
material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
material.ior = ior;
#ifdef USE_SPECULAR
float specularIntensityFactor = specularIntensity;
vec3 specularColorFactor = specularColor;
#ifdef USE_SPECULAR_COLORMAP
specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
#endif
material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
#else
float specularIntensityFactor = 1.0;
vec3 specularColorFactor = vec3( 1.0 );
material.specularF90 = 1.0;
#endif
material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
material.specularColor = vec3( 0.04 );
material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
material.clearcoat = clearcoat;
material.clearcoatRoughness = clearcoatRoughness;
material.clearcoatF0 = vec3( 0.04 );
material.clearcoatF90 = 1.0;
#ifdef USE_CLEARCOATMAP
material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
#endif
material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
material.clearcoatRoughness += geometryRoughness;
material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
material.iridescence = iridescence;
material.iridescenceIOR = iridescenceIOR;
#ifdef USE_IRIDESCENCEMAP
material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
#else
material.iridescenceThickness = iridescenceThicknessMaximum;
#endif
#endif
#ifdef USE_SHEEN
material.sheenColor = sheenColor;
#ifdef USE_SHEEN_COLORMAP
material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
#endif
material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
#ifdef USE_SHEEN_ROUGHNESSMAP
material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
#endif
#endif
#ifdef USE_ANISOTROPY
#ifdef USE_ANISOTROPYMAP
mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
#else
vec2 anisotropyV = anisotropyVector;
#endif
material.anisotropy = length( anisotropyV );
if( material.anisotropy == 0.0 ) {
anisotropyV = vec2( 1.0, 0.0 );
} else {
anisotropyV /= material.anisotropy;
material.anisotropy = saturate( material.anisotropy );
}
material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,qM=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
vec3 diffuseColor;
vec3 diffuseContribution;
vec3 specularColor;
vec3 specularColorBlended;
float roughness;
float metalness;
float specularF90;
float dispersion;
vec2 dfg;
vec3 multiScatteringCompensation;
#ifdef USE_DIFFUSE_ROUGHNESS
float diffuseRoughness;
#endif
#ifdef USE_RETROREFLECTION
float retroreflectivity;
#endif
#ifdef USE_CLEARCOAT
float clearcoat;
float clearcoatRoughness;
vec3 clearcoatF0;
float clearcoatF90;
#endif
#ifdef USE_IRIDESCENCE
float iridescence;
float iridescenceIOR;
float iridescenceThickness;
vec3 iridescenceFresnel;
vec3 iridescenceF0Dielectric;
vec3 iridescenceF0Metallic;
#endif
#ifdef USE_SHEEN
vec3 sheenColor;
float sheenRoughness;
#endif
#ifdef IOR
float ior;
#endif
#ifdef USE_TRANSMISSION
float transmission;
float transmissionAlpha;
float thickness;
float attenuationDistance;
vec3 attenuationColor;
#endif
#ifdef USE_ANISOTROPY
float anisotropy;
float alphaT;
vec3 anisotropyT;
vec3 anisotropyB;
#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
const float EON_EPSILON = 1e-7;
float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
float muComp = 1.0 - mu;
float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
return A * ( 1.0 + roughness * gOverPi );
}
vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
vec3 rho = saturate( diffuseColor );
if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
float dotNL = saturate( dot( normal, lightDir ) );
float dotNV = saturate( dot( normal, viewDir ) );
float s = dot( lightDir, viewDir ) - dotNL * dotNV;
float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
* max( EON_EPSILON, 1.0 - albedoV )
* max( EON_EPSILON, 1.0 - albedoL )
/ max( EON_EPSILON, 1.0 - averageAlbedo );
return singleScatter + multiScatter;
}
vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
vec3 rho = saturate( diffuseColor );
if ( roughness <= EON_EPSILON ) return rho;
float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
float a2 = pow2( alpha );
float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
float a2 = pow2( alpha );
float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
float a2 = alphaT * alphaB;
highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
highp float v2 = dot( v, v );
float w2 = a2 / v2;
return RECIPROCAL_PI * a2 * pow2 ( w2 );
}
#endif
#ifdef USE_CLEARCOAT
vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
vec3 f0 = material.clearcoatF0;
float f90 = material.clearcoatF90;
float roughness = max( material.clearcoatRoughness, 0.045 );
float alpha = pow2( roughness );
vec3 halfDir = normalize( lightDir + viewDir );
float dotNL = saturate( dot( normal, lightDir ) );
float dotNV = saturate( dot( normal, viewDir ) );
float dotNH = saturate( dot( normal, halfDir ) );
float dotVH = saturate( dot( viewDir, halfDir ) );
vec3 F = F_Schlick( f0, f90, dotVH );
float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
float D = D_GGX( alpha, dotNH );
return F * ( V * D );
}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
vec3 f0 = material.specularColorBlended;
float f90 = material.specularF90;
float roughness = max( material.roughness, 0.045 );
float alpha = pow2( roughness );
vec3 halfDir = normalize( lightDir + viewDir );
float dotNL = saturate( dot( normal, lightDir ) );
float dotNV = saturate( dot( normal, viewDir ) );
float dotNH = saturate( dot( normal, halfDir ) );
float dotVH = saturate( dot( viewDir, halfDir ) );
vec3 F = F_Schlick( f0, f90, dotVH );
#ifdef USE_IRIDESCENCE
F = mix( F, material.iridescenceFresnel, material.iridescence );
#endif
#ifdef USE_ANISOTROPY
float dotTL = dot( material.anisotropyT, lightDir );
float dotTV = dot( material.anisotropyT, viewDir );
float dotTH = dot( material.anisotropyT, halfDir );
float dotBL = dot( material.anisotropyB, lightDir );
float dotBV = dot( material.anisotropyB, viewDir );
float dotBH = dot( material.anisotropyB, halfDir );
float alphaT = max( material.alphaT, alpha );
float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
#else
float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
float D = D_GGX( alpha, dotNH );
#endif
return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
const float LUT_SIZE = 64.0;
const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
const float LUT_BIAS = 0.5 / LUT_SIZE;
float dotNV = saturate( dot( N, V ) );
vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
uv = uv * LUT_SCALE + LUT_BIAS;
return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
float l = length( f );
return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
float x = dot( v1, v2 );
float y = abs( x );
float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
float b = 3.4175940 + ( 4.1616724 + y ) * y;
float v = a / b;
float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
vec3 lightNormal = cross( v1, v2 );
if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
vec3 T1, T2;
T1 = normalize( V - N * dot( V, N ) );
T2 = - cross( N, T1 );
mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
vec3 coords[ 4 ];
coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
coords[ 0 ] = normalize( coords[ 0 ] );
coords[ 1 ] = normalize( coords[ 1 ] );
coords[ 2 ] = normalize( coords[ 2 ] );
coords[ 3 ] = normalize( coords[ 3 ] );
vec3 vectorFormFactor = vec3( 0.0 );
vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
float alpha = pow2( roughness );
float invAlpha = 1.0 / alpha;
float cos2h = dotNH * dotNH;
float sin2h = max( 1.0 - cos2h, 0.0078125 );
return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
vec3 halfDir = normalize( lightDir + viewDir );
float dotNL = saturate( dot( normal, lightDir ) );
float dotNV = saturate( dot( normal, viewDir ) );
float dotNH = saturate( dot( normal, halfDir ) );
float D = D_Charlie( sheenRoughness, dotNH );
float V = V_Neubelt( dotNV, dotNL );
return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
float dotNV = saturate( dot( normal, viewDir ) );
float r2 = roughness * roughness;
float rInv = 1.0 / ( roughness + 0.1 );
float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
float DG = exp( a * dotNV + b );
return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
float dotNV = saturate( dot( normal, viewDir ) );
vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
#ifdef USE_IRIDESCENCE
vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
#else
vec3 Fr = specularColor;
#endif
vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
float Ess = fab.x + fab.y;
float Ems = 1.0 - Ess;
vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
singleScatter += FssEss;
multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
vec3 normal = geometryNormal;
vec3 viewDir = geometryViewDir;
vec3 position = geometryPosition;
vec3 lightPos = rectAreaLight.position;
vec3 halfWidth = rectAreaLight.halfWidth;
vec3 halfHeight = rectAreaLight.halfHeight;
vec3 lightColor = rectAreaLight.color;
float roughness = material.roughness;
vec3 rectCoords[ 4 ];
rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
vec2 uv = LTC_Uv( normal, viewDir, roughness );
vec4 t1 = texture2D( ltc_1, uv );
vec4 t2 = texture2D( ltc_2, uv );
mat3 mInv = mat3(
vec3( t1.x, 0, t1.y ),
vec3(    0, 1,    0 ),
vec3( t1.z, 0, t1.w )
);
vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
#ifdef USE_CLEARCOAT
vec3 Ncc = geometryClearcoatNormal;
vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
mat3 mInvClearcoat = mat3(
vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
vec3(             0, 1,             0 ),
vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
);
vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
#endif
}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
vec3 irradiance = dotNL * directLight.color;
#ifdef USE_CLEARCOAT
float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
vec3 ccIrradiance = dotNLcc * directLight.color;
clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
#endif
#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
#ifdef USE_RETROREFLECTION
vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
#endif
reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
vec3 halfDir = normalize( directLight.direction + geometryViewDir );
float dotVH = saturate( dot( geometryViewDir, halfDir ) );
vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
#ifdef USE_RETROREFLECTION
vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
F = mix( F, retroF, saturate( material.retroreflectivity ) );
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
#else
vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
#endif
reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
vec3 singleScattering = vec3( 0.0 );
vec3 multiScattering = vec3( 0.0 );
#ifdef USE_IRIDESCENCE
computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
#else
computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
#else
vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
#endif
#ifdef USE_SHEEN
float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
diffuse *= sheenEnergyComp;
#endif
reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
#ifdef USE_CLEARCOAT
clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
#endif
#ifdef USE_SHEEN
sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
vec3 singleScatteringDielectric = vec3( 0.0 );
vec3 multiScatteringDielectric = vec3( 0.0 );
vec3 singleScatteringMetallic = vec3( 0.0 );
vec3 multiScatteringMetallic = vec3( 0.0 );
#ifdef USE_IRIDESCENCE
computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
#else
computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
#endif
vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
#ifdef USE_DIFFUSE_ROUGHNESS
float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
#else
vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
#endif
vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
vec3 indirectSpecular = radiance * singleScattering;
indirectSpecular += multiScattering * cosineWeightedIrradiance;
vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
#ifdef USE_SHEEN
float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
indirectSpecular *= sheenEnergyComp;
indirectDiffuse *= sheenEnergyComp;
#endif
reflectedLight.indirectSpecular += indirectSpecular;
reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,YM=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
float dotNVi = saturate( dot( normal, geometryViewDir ) );
if ( material.iridescenceThickness == 0.0 ) {
material.iridescence = 0.0;
} else {
material.iridescence = saturate( material.iridescence );
}
if ( material.iridescence > 0.0 ) {
vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
}
#endif
#ifdef STANDARD
float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
float EssMs = material.dfg.x + material.dfg.y;
material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
PointLight pointLight;
#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
PointLightShadow pointLightShadow;
#endif
#pragma unroll_loop_start
for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
pointLight = pointLights[ i ];
getPointLightInfo( pointLight, geometryPosition, directLight );
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
pointLightShadow = pointLightShadows[ i ];
directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
#endif
RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
SpotLight spotLight;
vec4 spotColor;
vec3 spotLightCoord;
bool inSpotLightMap;
#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
SpotLightShadow spotLightShadow;
#endif
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
spotLight = spotLights[ i ];
getSpotLightInfo( spotLight, geometryPosition, directLight );
#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
#else
#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
#endif
#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
#endif
#undef SPOT_LIGHT_MAP_INDEX
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
spotLightShadow = spotLightShadows[ i ];
directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
#endif
RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
SunLight sunLight;
#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
SunLightShadow sunLightShadow;
#endif
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
sunLight = sunLights[ i ];
getSunLightInfo( sunLight, directLight );
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
sunLightShadow = sunLightShadows[ i ];
directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
#endif
RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
DirectionalLight directionalLight;
#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
DirectionalLightShadow directionalLightShadow;
#endif
#pragma unroll_loop_start
for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
directionalLight = directionalLights[ i ];
getDirectionalLightInfo( directionalLight, directLight );
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
directionalLightShadow = directionalLightShadows[ i ];
directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
#endif
RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
RectAreaLight rectAreaLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
rectAreaLight = rectAreaLights[ i ];
RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
vec3 iblIrradiance = vec3( 0.0 );
vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
#if defined( USE_LIGHT_PROBES )
irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
#endif
#if ( NUM_HEMI_LIGHTS > 0 )
#pragma unroll_loop_start
for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
}
#pragma unroll_loop_end
#endif
#if NUM_LIGHT_PROBE_GRIDS > 0
vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
int probeGrid = - 1;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
}
#pragma unroll_loop_end
#pragma unroll_loop_start
for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
}
#pragma unroll_loop_end
#endif
#endif
#if defined( RE_IndirectSpecular )
vec3 radiance = vec3( 0.0 );
vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,$M=`#if defined( RE_IndirectDiffuse )
#ifdef USE_LIGHTMAP
vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
irradiance += lightMapIrradiance;
#endif
#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
iblIrradiance += getIBLIrradiance( geometryNormal );
#endif
#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
#ifdef USE_ANISOTROPY
vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
#else
vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
#endif
#ifdef USE_RETROREFLECTION
#ifdef USE_ANISOTROPY
vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
#else
vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
#endif
iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
#endif
radiance += iblRadiance;
#ifdef USE_CLEARCOAT
clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
#endif
#endif`,ZM=`#if defined( RE_IndirectDiffuse )
#if defined( LAMBERT ) || defined( PHONG )
irradiance += iblIrradiance;
#endif
RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,jM=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
vec3 spacing = ( probesMax - probesMin ) / probesResolution;
vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
vec3 margin = spacing * 0.01;
return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
vec3 res = probesResolution;
vec3 gridRange = probesMax - probesMin;
vec3 probeSpacing = gridRange / res;
vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
float nz          = res.z;
float paddedSlices = nz + 2.0;
float atlasDepth  = 7.0 * paddedSlices;
float uvZBase     = uvw.z * nz + 1.0;
vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
vec3 c0 = s0.xyz;
vec3 c1 = vec3( s0.w, s1.xy );
vec3 c2 = vec3( s1.zw, s2.x );
vec3 c3 = s2.yzw;
vec3 c4 = s3.xyz;
vec3 c5 = vec3( s3.w, s4.xy );
vec3 c6 = vec3( s4.zw, s5.x );
vec3 c7 = s5.yzw;
vec3 c8 = s6.xyz;
float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
vec3 result = c0 * 0.886227;
result += c1 * 2.0 * 0.511664 * y;
result += c2 * 2.0 * 0.511664 * z;
result += c3 * 2.0 * 0.511664 * x;
result += c4 * 2.0 * 0.429043 * x * y;
result += c5 * 2.0 * 0.429043 * y * z;
result += c6 * ( 0.743125 * z * z - 0.247708 );
result += c7 * 2.0 * 0.429043 * x * z;
result += c8 * 0.429043 * ( x * x - y * y );
return max( result, vec3( 0.0 ) );
}
#endif`,JM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,KM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
uniform float logDepthBufFC;
varying float vFragDepth;
varying float vIsPerspective;
#endif`,QM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
varying float vFragDepth;
varying float vIsPerspective;
#endif`,eb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
vFragDepth = 1.0 + gl_Position.w;
vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,tb=`#ifdef USE_MAP
vec4 sampledDiffuseColor = texture2D( map, vMapUv );
#ifdef DECODE_VIDEO_TEXTURE
sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
#endif
diffuseColor *= sampledDiffuseColor;
#endif`,nb=`#ifdef USE_MAP
uniform sampler2D map;
#endif`,ib=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
#if defined( USE_POINTS_UV )
vec2 uv = vUv;
#else
vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
#endif
#endif
#ifdef USE_MAP
diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,sb=`#if defined( USE_POINTS_UV )
varying vec2 vUv;
#else
#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
uniform mat3 uvTransform;
#endif
#endif
#ifdef USE_MAP
uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
uniform sampler2D alphaMap;
#endif`,rb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
metalnessFactor *= texelMetalness.b;
#endif`,ob=`#ifdef USE_METALNESSMAP
uniform sampler2D metalnessMap;
#endif`,ab=`#ifdef USE_INSTANCING_MORPH
float morphTargetInfluences[ MORPHTARGETS_COUNT ];
float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
}
#endif`,lb=`#if defined( USE_MORPHCOLORS )
#if defined( USE_COLOR_ALPHA )
vColor *= morphTargetBaseInfluence;
#elif defined( USE_COLOR )
vColor.rgb *= morphTargetBaseInfluence;
#endif
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
#if defined( USE_COLOR_ALPHA )
if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
#elif defined( USE_COLOR )
if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
#endif
}
#endif`,cb=`#ifdef USE_MORPHNORMALS
objectNormal *= morphTargetBaseInfluence;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
}
#endif`,hb=`#ifdef USE_MORPHTARGETS
#ifndef USE_INSTANCING_MORPH
uniform float morphTargetBaseInfluence;
uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
#endif
uniform sampler2DArray morphTargetsTexture;
uniform ivec2 morphTargetsTextureSize;
vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
int y = texelIndex / morphTargetsTextureSize.x;
int x = texelIndex - y * morphTargetsTextureSize.x;
ivec3 morphUV = ivec3( x, y, morphTargetIndex );
return texelFetch( morphTargetsTexture, morphUV, 0 );
}
#endif`,ub=`#ifdef USE_MORPHTARGETS
transformed *= morphTargetBaseInfluence;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
}
#endif`,db=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
vec3 fdx = dFdx( vViewPosition );
vec3 fdy = dFdy( vViewPosition );
vec3 normal = normalize( cross( fdx, fdy ) );
#else
vec3 normal = normalize( vNormal );
#ifdef DOUBLE_SIDED
normal *= faceDirection;
#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
#ifdef USE_TANGENT
mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
#else
mat3 tbn = getTangentFrame( - vViewPosition, normal,
#if defined( USE_NORMALMAP )
vNormalMapUv
#elif defined( USE_CLEARCOAT_NORMALMAP )
vClearcoatNormalMapUv
#else
vUv
#endif
);
#endif
#ifdef DOUBLE_SIDED
tbn[0] *= faceDirection;
tbn[1] *= faceDirection;
#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
#ifdef USE_TANGENT
mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
#else
mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
#endif
#ifdef DOUBLE_SIDED
tbn2[0] *= faceDirection;
tbn2[1] *= faceDirection;
#endif
#endif
vec3 nonPerturbedNormal = normal;`,fb=`#ifdef USE_NORMALMAP_OBJECTSPACE
normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
#ifdef FLIP_SIDED
normal = - normal;
#endif
#ifdef DOUBLE_SIDED
normal = normal * faceDirection;
#endif
normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
#if defined( USE_PACKED_NORMALMAP )
mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
#endif
mapN.xy *= normalScale;
normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,pb=`#ifndef FLAT_SHADED
varying vec3 vNormal;
#ifdef USE_TANGENT
varying vec3 vTangent;
varying vec3 vBitangent;
#endif
#endif`,mb=`#ifndef FLAT_SHADED
varying vec3 vNormal;
#ifdef USE_TANGENT
varying vec3 vTangent;
varying vec3 vBitangent;
#endif
#endif`,gb=`#ifndef FLAT_SHADED
vNormal = normalize( transformedNormal );
#ifdef USE_TANGENT
vTangent = normalize( transformedTangent );
vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
#ifdef FLIP_SIDED
vBitangent = - vBitangent;
#endif
#endif
#endif`,_b=`#ifdef USE_NORMALMAP
uniform sampler2D normalMap;
uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
vec3 q0 = dFdx( eye_pos.xyz );
vec3 q1 = dFdy( eye_pos.xyz );
vec2 st0 = dFdx( uv.st );
vec2 st1 = dFdy( uv.st );
vec3 N = surf_norm;
vec3 q1perp = cross( q1, N );
vec3 q0perp = cross( N, q0 );
vec3 T = q1perp * st0.x + q0perp * st1.x;
vec3 B = q1perp * st0.y + q0perp * st1.y;
float det = max( dot( T, T ), dot( B, B ) );
float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
return mat3( T * scale, B * scale, N );
}
#endif`,xb=`#ifdef USE_CLEARCOAT
vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,yb=`#ifdef USE_CLEARCOAT_NORMALMAP
vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
clearcoatMapN.xy *= clearcoatNormalScale;
clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,vb=`#ifdef USE_CLEARCOATMAP
uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
uniform sampler2D clearcoatNormalMap;
uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
uniform sampler2D clearcoatRoughnessMap;
#endif`,Sb=`#ifdef USE_IRIDESCENCEMAP
uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
uniform sampler2D iridescenceThicknessMap;
#endif`,Mb=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,bb=`vec3 packNormalToRGB( const in vec3 normal ) {
return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
if( v <= 0.0 )
return vec4( 0., 0., 0., 0. );
if( v >= 1.0 )
return vec4( 1., 1., 1., 1. );
float vuf;
float af = modf( v * PackFactors.a, vuf );
float bf = modf( vuf * ShiftRight8, vuf );
float gf = modf( vuf * ShiftRight8, vuf );
return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
if( v <= 0.0 )
return vec3( 0., 0., 0. );
if( v >= 1.0 )
return vec3( 1., 1., 1. );
float vuf;
float bf = modf( v * PackFactors.b, vuf );
float gf = modf( vuf * ShiftRight8, vuf );
return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
if( v <= 0.0 )
return vec2( 0., 0. );
if( v >= 1.0 )
return vec2( 1., 1. );
float vuf;
float gf = modf( v * 256., vuf );
return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
#ifdef USE_REVERSED_DEPTH_BUFFER

return depth * ( far - near ) - far;
#else
return depth * ( near - far ) - near;
#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {

#ifdef USE_REVERSED_DEPTH_BUFFER
return ( near * far ) / ( ( near - far ) * depth - near );
#else
return ( near * far ) / ( ( far - near ) * depth - far );
#endif
}`,wb=`#ifdef PREMULTIPLIED_ALPHA
gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Eb=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Tb=`#ifdef DITHERING
gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Ab=`#ifdef DITHERING
vec3 dithering( vec3 color ) {
float grid_position = rand( gl_FragCoord.xy );
vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
return color + dither_shift_RGB;
}
#endif`,Rb=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
roughnessFactor *= texelRoughness.g;
#endif`,Cb=`#ifdef USE_ROUGHNESSMAP
uniform sampler2D roughnessMap;
#endif`,Pb=`#if NUM_SPOT_LIGHT_COORDS > 0
varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
#if NUM_SUN_LIGHT_SHADOWS > 0
#define SUN_LIGHT_CASCADES 2
#if defined( SHADOWMAP_TYPE_PCF )
uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
#else
uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
#endif
uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
varying vec4 vSunShadowWorldPosition;
varying vec3 vSunShadowWorldNormal;
struct SunLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
#endif
#if NUM_DIR_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
#else
uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
#endif
varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
struct DirectionalLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
#endif
#if NUM_SPOT_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
#else
uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
#endif
struct SpotLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
#elif defined( SHADOWMAP_TYPE_BASIC )
uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
#endif
varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
struct PointLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
float shadowCameraNear;
float shadowCameraFar;
};
uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
#endif
#if defined( SHADOWMAP_TYPE_PCF )
float interleavedGradientNoise( vec2 position ) {
return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
}
vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
const float goldenAngle = 2.399963229728653;
float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
float theta = float( sampleIndex ) * goldenAngle + phi;
return vec2( cos( theta ), sin( theta ) ) * r;
}
#endif
#if defined( SHADOWMAP_TYPE_PCF )
float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
float shadow = 1.0;
shadowCoord.xyz /= shadowCoord.w;
#ifdef USE_REVERSED_DEPTH_BUFFER
shadowCoord.z -= shadowBias;
#else
shadowCoord.z += shadowBias;
#endif
bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
if ( frustumTest ) {
vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
vec2 radius = shadowRadius * texelSize;
float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
shadow = (
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
) * 0.2;
}
return mix( 1.0, shadow, shadowIntensity );
}
#elif defined( SHADOWMAP_TYPE_VSM )
float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
float shadow = 1.0;
shadowCoord.xyz /= shadowCoord.w;
#ifdef USE_REVERSED_DEPTH_BUFFER
shadowCoord.z -= shadowBias;
#else
shadowCoord.z += shadowBias;
#endif
bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
if ( frustumTest ) {
vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
float mean = distribution.x;
float variance = distribution.y * distribution.y;
#ifdef USE_REVERSED_DEPTH_BUFFER
float hard_shadow = step( mean, shadowCoord.z );
#else
float hard_shadow = step( shadowCoord.z, mean );
#endif

if ( hard_shadow == 1.0 ) {
shadow = 1.0;
} else {
variance = max( variance, 0.0000001 );
float d = shadowCoord.z - mean;
float p_max = variance / ( variance + d * d );
p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
shadow = max( hard_shadow, p_max );
}
}
return mix( 1.0, shadow, shadowIntensity );
}
#else
float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
float shadow = 1.0;
shadowCoord.xyz /= shadowCoord.w;
#ifdef USE_REVERSED_DEPTH_BUFFER
shadowCoord.z -= shadowBias;
#else
shadowCoord.z += shadowBias;
#endif
bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
if ( frustumTest ) {
float depth = texture2D( shadowMap, shadowCoord.xy ).r;
#ifdef USE_REVERSED_DEPTH_BUFFER
shadow = step( depth, shadowCoord.z );
#else
shadow = step( shadowCoord.z, depth );
#endif
}
return mix( 1.0, shadow, shadowIntensity );
}
#endif
#if NUM_SUN_LIGHT_SHADOWS > 0
float getSunShadow(
#if defined( SHADOWMAP_TYPE_PCF )
sampler2DShadow shadowMap,
#else
sampler2D shadowMap,
#endif
SunLightShadow sunLightShadow,
int shadowIndex
) {
vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
float viewDepth = vSunShadowWorldPosition.w;
int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
float shadow = 1.0;
for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
float cascadeShadow = getShadow(
shadowMap,
sunLightShadow.shadowMapSize,
sunLightShadow.shadowIntensity,
sunLightShadow.shadowBias,
sunLightShadow.shadowRadius,
sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
);
shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
}
}
return shadow;
}
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
float shadow = 1.0;
vec3 lightToPosition = shadowCoord.xyz;
vec3 bd3D = normalize( lightToPosition );
vec3 absVec = abs( lightToPosition );
float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
float lightDistance = length( lightToPosition );
float depthRange = shadowCameraFar - shadowCameraNear;
#ifdef USE_REVERSED_DEPTH_BUFFER
float depthA = - shadowCameraNear / depthRange - shadowBias;
float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
#else
float depthA = shadowCameraFar / depthRange + shadowBias;
float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
#endif
float texelSize = shadowRadius / shadowMapSize.x;
vec3 absDir = abs( bd3D );
vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
tangent = normalize( cross( bd3D, tangent ) );
vec3 bitangent = cross( bd3D, tangent );
float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
shadow = 0.0;
for ( int i = 0; i < 5; i ++ ) {
vec2 offset = vogelDiskSample( i, 5, phi );
vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
vec3 absDirection = abs( direction );
float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
shadow += texture( shadowMap, vec4( direction, dp ) );
}
shadow *= 0.2;
}
return mix( 1.0, shadow, shadowIntensity );
}
#elif defined( SHADOWMAP_TYPE_BASIC )
float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
float shadow = 1.0;
vec3 lightToPosition = shadowCoord.xyz;
vec3 absVec = abs( lightToPosition );
float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
dp += shadowBias;
vec3 bd3D = normalize( lightToPosition );
float depth = textureCube( shadowMap, bd3D ).r;
#ifdef USE_REVERSED_DEPTH_BUFFER
depth = 1.0 - depth;
#endif
shadow = step( dp, depth );
}
return mix( 1.0, shadow, shadowIntensity );
}
#endif
#endif
#endif`,Ib=`#if NUM_SPOT_LIGHT_COORDS > 0
uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
#if NUM_SUN_LIGHT_SHADOWS > 0
varying vec4 vSunShadowWorldPosition;
varying vec3 vSunShadowWorldNormal;
#endif
#if NUM_DIR_LIGHT_SHADOWS > 0
uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
struct DirectionalLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
#endif
#if NUM_SPOT_LIGHT_SHADOWS > 0
struct SpotLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
struct PointLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
float shadowCameraNear;
float shadowCameraFar;
};
uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
#endif
#endif`,Lb=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
#ifdef HAS_NORMAL
vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
#else
vec3 shadowWorldNormal = vec3( 0.0 );
#endif
vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
#if NUM_SUN_LIGHT_SHADOWS > 0
vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
vSunShadowWorldNormal = shadowWorldNormal;
#endif
#if NUM_DIR_LIGHT_SHADOWS > 0
#pragma unroll_loop_start
for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
}
#pragma unroll_loop_end
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
#pragma unroll_loop_start
for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
}
#pragma unroll_loop_end
#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
shadowWorldPosition = worldPosition;
#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
#endif
vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
}
#pragma unroll_loop_end
#endif`,Db=`float getShadowMask() {
float shadow = 1.0;
#ifdef USE_SHADOWMAP
#if NUM_SUN_LIGHT_SHADOWS > 0
SunLightShadow sunLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
sunLight = sunLightShadows[ i ];
shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
}
#pragma unroll_loop_end
#endif
#if NUM_DIR_LIGHT_SHADOWS > 0
DirectionalLightShadow directionalLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
directionalLight = directionalLightShadows[ i ];
shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
}
#pragma unroll_loop_end
#endif
#if NUM_SPOT_LIGHT_SHADOWS > 0
SpotLightShadow spotLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
spotLight = spotLightShadows[ i ];
shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
}
#pragma unroll_loop_end
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
PointLightShadow pointLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
pointLight = pointLightShadows[ i ];
shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
}
#pragma unroll_loop_end
#endif
#endif
return shadow;
}`,Nb=`#ifdef USE_SKINNING
mat4 boneMatX = getBoneMatrix( skinIndex.x );
mat4 boneMatY = getBoneMatrix( skinIndex.y );
mat4 boneMatZ = getBoneMatrix( skinIndex.z );
mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Ub=`#ifdef USE_SKINNING
uniform mat4 bindMatrix;
uniform mat4 bindMatrixInverse;
uniform highp sampler2D boneTexture;
mat4 getBoneMatrix( const in float i ) {
int size = textureSize( boneTexture, 0 ).x;
int j = int( i ) * 4;
int x = j % size;
int y = j / size;
vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
return mat4( v1, v2, v3, v4 );
}
#endif`,Fb=`#ifdef USE_SKINNING
vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
vec4 skinned = vec4( 0.0 );
skinned += boneMatX * skinVertex * skinWeight.x;
skinned += boneMatY * skinVertex * skinWeight.y;
skinned += boneMatZ * skinVertex * skinWeight.z;
skinned += boneMatW * skinVertex * skinWeight.w;
transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Ob=`#ifdef USE_SKINNING
mat4 skinMatrix = mat4( 0.0 );
skinMatrix += skinWeight.x * boneMatX;
skinMatrix += skinWeight.y * boneMatY;
skinMatrix += skinWeight.z * boneMatZ;
skinMatrix += skinWeight.w * boneMatW;
skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
#ifdef USE_TANGENT
objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
#endif
#endif`,Bb=`float specularStrength;
#ifdef USE_SPECULARMAP
vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
specularStrength = texelSpecular.r;
#else
specularStrength = 1.0;
#endif`,kb=`#ifdef USE_SPECULARMAP
uniform sampler2D specularMap;
#endif`,zb=`#if defined( TONE_MAPPING )
gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Vb=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
color *= toneMappingExposure;
return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
color *= toneMappingExposure;
color = max( vec3( 0.0 ), color - 0.004 );
return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
const mat3 ACESInputMat = mat3(
vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
vec3( 0.04823, 0.01566, 0.83777 )
);
const mat3 ACESOutputMat = mat3(
vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
vec3( -0.07367, -0.00605,  1.07602 )
);
color *= toneMappingExposure / 0.6;
color = ACESInputMat * color;
color = RRTAndODTFit( color );
color = ACESOutputMat * color;
return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
vec3( 1.6605, - 0.1246, - 0.0182 ),
vec3( - 0.5876, 1.1329, - 0.1006 ),
vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
vec3( 0.6274, 0.0691, 0.0164 ),
vec3( 0.3293, 0.9195, 0.0880 ),
vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
vec3 x2 = x * x;
vec3 x4 = x2 * x2;
return + 15.5 * x4 * x2
- 40.14 * x4 * x
+ 31.96 * x4
- 6.868 * x2 * x
+ 0.4298 * x2
+ 0.1191 * x
- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
const mat3 AgXInsetMatrix = mat3(
vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
);
const mat3 AgXOutsetMatrix = mat3(
vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
);
const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
color *= toneMappingExposure;
color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
color = AgXInsetMatrix * color;
color = max( color, 1e-10 );	color = log2( color );
color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
color = clamp( color, 0.0, 1.0 );
color = agxDefaultContrastApprox( color );
color = AgXOutsetMatrix * color;
color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
color = clamp( color, 0.0, 1.0 );
return color;
}
vec3 NeutralToneMapping( vec3 color ) {
const float StartCompression = 0.8 - 0.04;
const float Desaturation = 0.15;
color *= toneMappingExposure;
float x = min( color.r, min( color.g, color.b ) );
float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
color -= offset;
float peak = max( color.r, max( color.g, color.b ) );
if ( peak < StartCompression ) return color;
float d = 1. - StartCompression;
float newPeak = 1. - d * d / ( peak + d - StartCompression );
color *= newPeak / peak;
float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,Gb=`#ifdef USE_TRANSMISSION
material.transmission = transmission;
material.transmissionAlpha = 1.0;
material.thickness = thickness;
material.attenuationDistance = attenuationDistance;
material.attenuationColor = attenuationColor;
#ifdef USE_TRANSMISSIONMAP
material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
#endif
#ifdef USE_THICKNESSMAP
material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
#endif
vec3 pos = vWorldPosition;
vec3 v = normalize( cameraPosition - pos );
vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
vec4 transmitted = getIBLVolumeRefraction(
n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
material.attenuationColor, material.attenuationDistance );
material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Hb=`#ifdef USE_TRANSMISSION
uniform float transmission;
uniform float thickness;
uniform float attenuationDistance;
uniform vec3 attenuationColor;
#ifdef USE_TRANSMISSIONMAP
uniform sampler2D transmissionMap;
#endif
#ifdef USE_THICKNESSMAP
uniform sampler2D thicknessMap;
#endif
uniform vec2 transmissionSamplerSize;
uniform sampler2D transmissionSamplerMap;
uniform mat4 modelMatrix;
uniform mat4 projectionMatrix;
varying vec3 vWorldPosition;
float w0( float a ) {
return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
}
float w1( float a ) {
return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
}
float w2( float a ){
return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
}
float w3( float a ) {
return ( 1.0 / 6.0 ) * ( a * a * a );
}
float g0( float a ) {
return w0( a ) + w1( a );
}
float g1( float a ) {
return w2( a ) + w3( a );
}
float h0( float a ) {
return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
}
float h1( float a ) {
return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
}
vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
uv = uv * texelSize.zw + 0.5;
vec2 iuv = floor( uv );
vec2 fuv = fract( uv );
float g0x = g0( fuv.x );
float g1x = g1( fuv.x );
float h0x = h0( fuv.x );
float h1x = h1( fuv.x );
float h0y = h0( fuv.y );
float h1y = h1( fuv.y );
vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
}
vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
vec2 fLodSizeInv = 1.0 / fLodSize;
vec2 cLodSizeInv = 1.0 / cLodSize;
vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
return mix( fSample, cSample, fract( lod ) );
}
vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
vec3 modelScale;
modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
return normalize( refractionVector ) * thickness * modelScale;
}
float applyIorToRoughness( const in float roughness, const in float ior ) {
return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
}
vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
}
vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
if ( isinf( attenuationDistance ) ) {
return vec3( 1.0 );
} else {
vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
}
}
vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
const in vec3 attenuationColor, const in float attenuationDistance ) {
vec4 transmittedLight;
vec3 transmittance;
#ifdef USE_DISPERSION
float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
for ( int i = 0; i < 3; i ++ ) {
vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
vec3 refractedRayExit = position + transmissionRay;
vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
vec2 refractionCoords = ndcPos.xy / ndcPos.w;
refractionCoords += 1.0;
refractionCoords /= 2.0;
vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
transmittedLight[ i ] = transmissionSample[ i ];
transmittedLight.a += transmissionSample.a;
transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
}
transmittedLight.a /= 3.0;
#else
vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
vec3 refractedRayExit = position + transmissionRay;
vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
vec2 refractionCoords = ndcPos.xy / ndcPos.w;
refractionCoords += 1.0;
refractionCoords /= 2.0;
transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
#endif
vec3 attenuatedColor = transmittance * transmittedLight.rgb;
vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
}
#endif`,Wb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
varying vec2 vUv;
#endif
#ifdef USE_MAP
varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
uniform mat3 transmissionMapTransform;
varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
uniform mat3 thicknessMapTransform;
varying vec2 vThicknessMapUv;
#endif`,Xb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
varying vec2 vUv;
#endif
#ifdef USE_MAP
uniform mat3 mapTransform;
varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
uniform mat3 alphaMapTransform;
varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
uniform mat3 lightMapTransform;
varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
uniform mat3 aoMapTransform;
varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
uniform mat3 bumpMapTransform;
varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
uniform mat3 normalMapTransform;
varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
uniform mat3 displacementMapTransform;
varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
uniform mat3 emissiveMapTransform;
varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
uniform mat3 metalnessMapTransform;
varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
uniform mat3 roughnessMapTransform;
varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
uniform mat3 diffuseRoughnessMapTransform;
varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
uniform mat3 anisotropyMapTransform;
varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
uniform mat3 clearcoatMapTransform;
varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
uniform mat3 clearcoatNormalMapTransform;
varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
uniform mat3 clearcoatRoughnessMapTransform;
varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
uniform mat3 sheenColorMapTransform;
varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
uniform mat3 sheenRoughnessMapTransform;
varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
uniform mat3 iridescenceMapTransform;
varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
uniform mat3 iridescenceThicknessMapTransform;
varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
uniform mat3 specularMapTransform;
varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
uniform mat3 specularColorMapTransform;
varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
uniform mat3 specularIntensityMapTransform;
varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
uniform mat3 transmissionMapTransform;
varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
uniform mat3 thicknessMapTransform;
varying vec2 vThicknessMapUv;
#endif`,qb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,Yb=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
vec4 worldPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
worldPosition = batchingMatrix * worldPosition;
#endif
#ifdef USE_INSTANCING
worldPosition = instanceMatrix * worldPosition;
#endif
worldPosition = modelMatrix * worldPosition;
#endif`,$b=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Zb=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
vec4 texColor = texture2D( t2D, vUv );
#ifdef DECODE_VIDEO_TEXTURE
texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
#endif
texColor.rgb *= backgroundIntensity;
gl_FragColor = texColor;
#include <tonemapping_fragment>
#include <colorspace_fragment>
}`,jb=`varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
gl_Position.z = gl_Position.w;
}`,Jb=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
#ifdef ENVMAP_TYPE_PMREM
vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
#else
vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
#endif
texColor.rgb *= backgroundIntensity;
gl_FragColor = texColor;
#include <tonemapping_fragment>
#include <colorspace_fragment>
}`,Kb=`varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
gl_Position.z = gl_Position.w;
}`,Qb=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
gl_FragColor = texColor;
gl_FragColor.a *= opacity;
#include <tonemapping_fragment>
#include <colorspace_fragment>
}`,e1=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
#include <uv_vertex>
#include <batching_vertex>
#include <skinbase_vertex>
#include <morphinstance_vertex>
#ifdef USE_DISPLACEMENTMAP
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinnormal_vertex>
#endif
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
vHighPrecisionZW = gl_Position.zw;
}`,t1=`#if DEPTH_PACKING == 3200
uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
vec4 diffuseColor = vec4( 1.0 );
#include <clipping_planes_fragment>
#if DEPTH_PACKING == 3200
diffuseColor.a = opacity;
#endif
#include <map_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <logdepthbuf_fragment>
#ifdef USE_REVERSED_DEPTH_BUFFER
float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
#else
float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
#endif
#if DEPTH_PACKING == 3200
gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
#elif DEPTH_PACKING == 3201
gl_FragColor = packDepthToRGBA( fragCoordZ );
#elif DEPTH_PACKING == 3202
gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
#elif DEPTH_PACKING == 3203
gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
#endif
}`,n1=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <batching_vertex>
#include <skinbase_vertex>
#include <morphinstance_vertex>
#ifdef USE_DISPLACEMENTMAP
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinnormal_vertex>
#endif
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <worldpos_vertex>
#include <clipping_planes_vertex>
vWorldPosition = worldPosition.xyz;
}`,i1=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( 1.0 );
#include <clipping_planes_fragment>
#include <map_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
float dist = length( vWorldPosition - referencePosition );
dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
dist = saturate( dist );
gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,s1=`varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
}`,r1=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
vec3 direction = normalize( vWorldDirection );
vec2 sampleUV = equirectUv( direction );
gl_FragColor = texture2D( tEquirect, sampleUV );
#include <tonemapping_fragment>
#include <colorspace_fragment>
}`,o1=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
vLineDistance = scale * lineDistance;
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <fog_vertex>
}`,a1=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
if ( mod( vLineDistance, totalSize ) > dashSize ) {
discard;
}
vec3 outgoingLight = vec3( 0.0 );
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
outgoingLight = diffuseColor.rgb;
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
}`,l1=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#endif
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <worldpos_vertex>
#include <envmap_vertex>
#include <fog_vertex>
}`,c1=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <specularmap_fragment>
ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
#ifdef USE_LIGHTMAP
vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
#else
reflectedLight.indirectDiffuse += vec3( 1.0 );
#endif
#include <aomap_fragment>
reflectedLight.indirectDiffuse *= diffuseColor.rgb;
vec3 outgoingLight = reflectedLight.indirectDiffuse;
#include <envmap_fragment>
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}`,h1=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
vViewPosition = - mvPosition.xyz;
#include <worldpos_vertex>
#include <envmap_vertex>
#include <shadowmap_vertex>
#include <fog_vertex>
}`,u1=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
vec3 totalEmissiveRadiance = emissive;
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <specularmap_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
#include <emissivemap_fragment>
#include <lights_lambert_fragment>
#include <lights_fragment_begin>
#include <lights_fragment_maps>
#include <lights_fragment_end>
#include <aomap_fragment>
vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
#include <envmap_fragment>
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}`,d1=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <fog_vertex>
vViewPosition = - mvPosition.xyz;
}`,f1=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
vec3 viewDir = normalize( vViewPosition );
vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
vec3 y = cross( viewDir, x );
vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
#ifdef USE_MATCAP
vec4 matcapColor = texture2D( matcap, uv );
#else
vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
#endif
vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}`,p1=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphinstance_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
vViewPosition = - mvPosition.xyz;
#endif
}`,m1=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
#include <clipping_planes_fragment>
#include <logdepthbuf_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
#ifdef OPAQUE
gl_FragColor.a = 1.0;
#endif
}`,g1=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphinstance_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
vViewPosition = - mvPosition.xyz;
#include <worldpos_vertex>
#include <envmap_vertex>
#include <shadowmap_vertex>
#include <fog_vertex>
}`,_1=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
vec3 totalEmissiveRadiance = emissive;
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <specularmap_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
#include <emissivemap_fragment>
#include <lights_phong_fragment>
#include <lights_fragment_begin>
#include <lights_fragment_maps>
#include <lights_fragment_end>
#include <aomap_fragment>
vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
#include <envmap_fragment>
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}`,x1=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
vViewPosition = - mvPosition.xyz;
#include <worldpos_vertex>
#include <shadowmap_vertex>
#include <fog_vertex>
#ifdef USE_TRANSMISSION
vWorldPosition = worldPosition.xyz;
#endif
}`,y1=`#define STANDARD
#ifdef PHYSICAL
#define IOR
#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
uniform float ior;
#endif
#ifdef USE_SPECULAR
uniform float specularIntensity;
uniform vec3 specularColor;
#ifdef USE_SPECULAR_COLORMAP
uniform sampler2D specularColorMap;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
uniform sampler2D specularIntensityMap;
#endif
#endif
#ifdef USE_CLEARCOAT
uniform float clearcoat;
uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
uniform float diffuseRoughness;
#ifdef USE_DIFFUSE_ROUGHNESSMAP
uniform sampler2D diffuseRoughnessMap;
#endif
#endif
#ifdef USE_DISPERSION
uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
uniform float iridescence;
uniform float iridescenceIOR;
uniform float iridescenceThicknessMinimum;
uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
uniform vec3 sheenColor;
uniform float sheenRoughness;
#ifdef USE_SHEEN_COLORMAP
uniform sampler2D sheenColorMap;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
uniform sampler2D sheenRoughnessMap;
#endif
#endif
#ifdef USE_ANISOTROPY
uniform vec2 anisotropyVector;
#ifdef USE_ANISOTROPYMAP
uniform sampler2D anisotropyMap;
#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
vec3 totalEmissiveRadiance = emissive;
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <roughnessmap_fragment>
#include <metalnessmap_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
#include <clearcoat_normal_fragment_begin>
#include <clearcoat_normal_fragment_maps>
#include <emissivemap_fragment>
#include <lights_physical_fragment>
#include <lights_fragment_begin>
#include <lights_fragment_maps>
#include <lights_fragment_end>
#include <aomap_fragment>
vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
#include <transmission_fragment>
vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
#ifdef USE_SHEEN
 
outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
#ifdef USE_CLEARCOAT
float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
#endif
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}`,v1=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
vViewPosition = - mvPosition.xyz;
#include <worldpos_vertex>
#include <shadowmap_vertex>
#include <fog_vertex>
}`,S1=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
vec3 totalEmissiveRadiance = emissive;
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
#include <emissivemap_fragment>
#include <lights_toon_fragment>
#include <lights_fragment_begin>
#include <lights_fragment_maps>
#include <lights_fragment_end>
#include <aomap_fragment>
vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}`,M1=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
varying vec2 vUv;
uniform mat3 uvTransform;
#endif
void main() {
#ifdef USE_POINTS_UV
vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
#endif
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <project_vertex>
gl_PointSize = size;
#ifdef USE_SIZEATTENUATION
bool isPerspective = isPerspectiveMatrix( projectionMatrix );
if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
#endif
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <worldpos_vertex>
#include <fog_vertex>
}`,b1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
vec3 outgoingLight = vec3( 0.0 );
#include <logdepthbuf_fragment>
#include <map_particle_fragment>
#include <color_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
outgoingLight = diffuseColor.rgb;
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
}`,w1=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphinstance_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <worldpos_vertex>
#include <shadowmap_vertex>
#include <fog_vertex>
}`,E1=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
#include <logdepthbuf_fragment>
gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
}`,T1=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
vec4 mvPosition = modelViewMatrix[ 3 ];
vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
#ifndef USE_SIZEATTENUATION
bool isPerspective = isPerspectiveMatrix( projectionMatrix );
if ( isPerspective ) scale *= - mvPosition.z;
#endif
vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
vec2 rotatedPosition;
rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
mvPosition.xy += rotatedPosition;
gl_Position = projectionMatrix * mvPosition;
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <fog_vertex>
}`,A1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
vec3 outgoingLight = vec3( 0.0 );
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
outgoingLight = diffuseColor.rgb;
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
}`,ft={alphahash_fragment:ZS,alphahash_pars_fragment:jS,alphamap_fragment:JS,alphamap_pars_fragment:KS,alphatest_fragment:QS,alphatest_pars_fragment:eM,aomap_fragment:tM,aomap_pars_fragment:nM,batching_pars_vertex:iM,batching_vertex:sM,begin_vertex:rM,beginnormal_vertex:oM,bsdfs:aM,iridescence_fragment:lM,bumpmap_pars_fragment:cM,clipping_planes_fragment:hM,clipping_planes_pars_fragment:uM,clipping_planes_pars_vertex:dM,clipping_planes_vertex:fM,color_fragment:pM,color_pars_fragment:mM,color_pars_vertex:gM,color_vertex:_M,common:xM,defaultnormal_vertex:yM,displacementmap_pars_vertex:vM,displacementmap_vertex:SM,emissivemap_fragment:MM,emissivemap_pars_fragment:bM,colorspace_fragment:wM,colorspace_pars_fragment:EM,envmap_fragment:TM,envmap_common_pars_fragment:AM,envmap_pars_fragment:RM,envmap_pars_vertex:CM,envmap_physical_pars_fragment:zM,envmap_vertex:PM,fog_vertex:IM,fog_pars_vertex:LM,fog_fragment:DM,fog_pars_fragment:NM,gradientmap_pars_fragment:UM,lightmap_pars_fragment:FM,lights_lambert_fragment:OM,lights_lambert_pars_fragment:BM,lights_pars_begin:kM,lights_toon_fragment:VM,lights_toon_pars_fragment:GM,lights_phong_fragment:HM,lights_phong_pars_fragment:WM,lights_physical_fragment:XM,lights_physical_pars_fragment:qM,lights_fragment_begin:YM,lights_fragment_maps:$M,lights_fragment_end:ZM,lightprobes_pars_fragment:jM,logdepthbuf_fragment:JM,logdepthbuf_pars_fragment:KM,logdepthbuf_pars_vertex:QM,logdepthbuf_vertex:eb,map_fragment:tb,map_pars_fragment:nb,map_particle_fragment:ib,map_particle_pars_fragment:sb,metalnessmap_fragment:rb,metalnessmap_pars_fragment:ob,morphinstance_vertex:ab,morphcolor_vertex:lb,morphnormal_vertex:cb,morphtarget_pars_vertex:hb,morphtarget_vertex:ub,normal_fragment_begin:db,normal_fragment_maps:fb,normal_pars_fragment:pb,normal_pars_vertex:mb,normal_vertex:gb,normalmap_pars_fragment:_b,clearcoat_normal_fragment_begin:xb,clearcoat_normal_fragment_maps:yb,clearcoat_pars_fragment:vb,iridescence_pars_fragment:Sb,opaque_fragment:Mb,packing:bb,premultiplied_alpha_fragment:wb,project_vertex:Eb,dithering_fragment:Tb,dithering_pars_fragment:Ab,roughnessmap_fragment:Rb,roughnessmap_pars_fragment:Cb,shadowmap_pars_fragment:Pb,shadowmap_pars_vertex:Ib,shadowmap_vertex:Lb,shadowmask_pars_fragment:Db,skinbase_vertex:Nb,skinning_pars_vertex:Ub,skinning_vertex:Fb,skinnormal_vertex:Ob,specularmap_fragment:Bb,specularmap_pars_fragment:kb,tonemapping_fragment:zb,tonemapping_pars_fragment:Vb,transmission_fragment:Gb,transmission_pars_fragment:Hb,uv_pars_fragment:Wb,uv_pars_vertex:Xb,uv_vertex:qb,worldpos_vertex:Yb,background_vert:$b,background_frag:Zb,backgroundCube_vert:jb,backgroundCube_frag:Jb,cube_vert:Kb,cube_frag:Qb,depth_vert:e1,depth_frag:t1,distance_vert:n1,distance_frag:i1,equirect_vert:s1,equirect_frag:r1,linedashed_vert:o1,linedashed_frag:a1,meshbasic_vert:l1,meshbasic_frag:c1,meshlambert_vert:h1,meshlambert_frag:u1,meshmatcap_vert:d1,meshmatcap_frag:f1,meshnormal_vert:p1,meshnormal_frag:m1,meshphong_vert:g1,meshphong_frag:_1,meshphysical_vert:x1,meshphysical_frag:y1,meshtoon_vert:v1,meshtoon_frag:S1,points_vert:M1,points_frag:b1,shadow_vert:w1,shadow_frag:E1,sprite_vert:T1,sprite_frag:A1},Ie={common:{diffuse:{value:new ht(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new rt},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new rt}},envmap:{envMap:{value:null},envMapRotation:{value:new rt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new rt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new rt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new rt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new rt},normalScale:{value:new Ke(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new rt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new rt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new rt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new rt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ht(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ht(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0},uvTransform:{value:new rt}},sprite:{diffuse:{value:new ht(16777215)},opacity:{value:1},center:{value:new Ke(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new rt},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0}}},ni={basic:{uniforms:Vn([Ie.common,Ie.specularmap,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.fog]),vertexShader:ft.meshbasic_vert,fragmentShader:ft.meshbasic_frag},lambert:{uniforms:Vn([Ie.common,Ie.specularmap,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.fog,Ie.lights,{emissive:{value:new ht(0)},envMapIntensity:{value:1}}]),vertexShader:ft.meshlambert_vert,fragmentShader:ft.meshlambert_frag},phong:{uniforms:Vn([Ie.common,Ie.specularmap,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.fog,Ie.lights,{emissive:{value:new ht(0)},specular:{value:new ht(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ft.meshphong_vert,fragmentShader:ft.meshphong_frag},standard:{uniforms:Vn([Ie.common,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.roughnessmap,Ie.metalnessmap,Ie.fog,Ie.lights,{emissive:{value:new ht(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag},toon:{uniforms:Vn([Ie.common,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.gradientmap,Ie.fog,Ie.lights,{emissive:{value:new ht(0)}}]),vertexShader:ft.meshtoon_vert,fragmentShader:ft.meshtoon_frag},matcap:{uniforms:Vn([Ie.common,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.fog,{matcap:{value:null}}]),vertexShader:ft.meshmatcap_vert,fragmentShader:ft.meshmatcap_frag},points:{uniforms:Vn([Ie.points,Ie.fog]),vertexShader:ft.points_vert,fragmentShader:ft.points_frag},dashed:{uniforms:Vn([Ie.common,Ie.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ft.linedashed_vert,fragmentShader:ft.linedashed_frag},depth:{uniforms:Vn([Ie.common,Ie.displacementmap]),vertexShader:ft.depth_vert,fragmentShader:ft.depth_frag},normal:{uniforms:Vn([Ie.common,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,{opacity:{value:1}}]),vertexShader:ft.meshnormal_vert,fragmentShader:ft.meshnormal_frag},sprite:{uniforms:Vn([Ie.sprite,Ie.fog]),vertexShader:ft.sprite_vert,fragmentShader:ft.sprite_frag},background:{uniforms:{uvTransform:{value:new rt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ft.background_vert,fragmentShader:ft.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new rt}},vertexShader:ft.backgroundCube_vert,fragmentShader:ft.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ft.cube_vert,fragmentShader:ft.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ft.equirect_vert,fragmentShader:ft.equirect_frag},distance:{uniforms:Vn([Ie.common,Ie.displacementmap,{referencePosition:{value:new X},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ft.distance_vert,fragmentShader:ft.distance_frag},shadow:{uniforms:Vn([Ie.lights,Ie.fog,{color:{value:new ht(0)},opacity:{value:1}}]),vertexShader:ft.shadow_vert,fragmentShader:ft.shadow_frag}};ni.physical={uniforms:Vn([ni.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new rt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new rt},clearcoatNormalScale:{value:new Ke(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new rt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new rt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new rt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new rt},sheen:{value:0},sheenColor:{value:new ht(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new rt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new rt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new rt},transmissionSamplerSize:{value:new Ke},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new rt},attenuationDistance:{value:0},attenuationColor:{value:new ht(0)},specularColor:{value:new ht(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new rt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new rt},anisotropyVector:{value:new Ke},anisotropyMap:{value:null},anisotropyMapTransform:{value:new rt}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag};var kh={r:0,b:0,g:0},R1=new Ot,d_=new rt;d_.set(-1,0,0,0,1,0,0,0,1);function C1(n,e,t,i,s,r){let o=new ht(0),a=s===!0?0:1,l,c,h=null,d=0,u=null;function m(M){let P=M.isScene===!0?M.background:null;if(P&&P.isTexture){let y=M.backgroundBlurriness>0;P=e.get(P,y)}return P}function g(M){let P=!1,y=m(M);y===null?f(o,a):y&&y.isColor&&(f(y,1),P=!0);let A=n.xr.getEnvironmentBlendMode();A==="additive"?t.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||P)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(M,P){let y=m(P);y&&y.isCubeTexture?(c===void 0&&(c=new zn(new Js(1,1,1),new Ti({name:"BackgroundCubeMaterial",uniforms:Or(ni.backgroundCube.uniforms),vertexShader:ni.backgroundCube.vertexShader,fragmentShader:ni.backgroundCube.fragmentShader,side:ti,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(A,b,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=y,c.material.uniforms.backgroundBlurriness.value=P.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=P.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(R1.makeRotationFromEuler(P.backgroundRotation)).transpose(),y.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(d_),c.material.toneMapped=vt.getTransfer(y.colorSpace)!==Lt,(h!==y||d!==y.version||u!==n.toneMapping)&&(c.material.needsUpdate=!0,h=y,d=y.version,u=n.toneMapping),c.layers.enableAll(),M.unshift(c,c.geometry,c.material,0,0,null)):y&&y.isTexture&&(l===void 0&&(l=new zn(new Lr(2,2),new Ti({name:"BackgroundMaterial",uniforms:Or(ni.background.uniforms),vertexShader:ni.background.vertexShader,fragmentShader:ni.background.fragmentShader,side:sr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=y,l.material.uniforms.backgroundIntensity.value=P.backgroundIntensity,l.material.toneMapped=vt.getTransfer(y.colorSpace)!==Lt,y.matrixAutoUpdate===!0&&y.updateMatrix(),l.material.uniforms.uvTransform.value.copy(y.matrix),(h!==y||d!==y.version||u!==n.toneMapping)&&(l.material.needsUpdate=!0,h=y,d=y.version,u=n.toneMapping),l.layers.enableAll(),M.unshift(l,l.geometry,l.material,0,0,null))}function f(M,P){M.getRGB(kh,_f(n)),t.buffers.color.setClear(kh.r,kh.g,kh.b,P,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(M,P=1){o.set(M),a=P,f(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(M){a=M,f(o,a)},render:g,addToRenderList:x,dispose:p}}function P1(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=u(null),r=s,o=!1;function a(E,L,F,I,O){let V=!1,k=d(E,I,F,L);r!==k&&(r=k,c(r.object)),V=m(E,I,F,O),V&&g(E,I,F,O),O!==null&&e.update(O,n.ELEMENT_ARRAY_BUFFER),(V||o)&&(o=!1,y(E,L,F,I),O!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(O).buffer))}function l(){return n.createVertexArray()}function c(E){return n.bindVertexArray(E)}function h(E){return n.deleteVertexArray(E)}function d(E,L,F,I){let O=I.wireframe===!0,V=i[L.id];V===void 0&&(V={},i[L.id]=V);let k=E.isInstancedMesh===!0?E.id:0,K=V[k];K===void 0&&(K={},V[k]=K);let Y=K[F.id];Y===void 0&&(Y={},K[F.id]=Y);let Z=Y[O];return Z===void 0&&(Z=u(l()),Y[O]=Z),Z}function u(E){let L=[],F=[],I=[];for(let O=0;O<t;O++)L[O]=0,F[O]=0,I[O]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:L,enabledAttributes:F,attributeDivisors:I,object:E,attributes:{},index:null}}function m(E,L,F,I){let O=r.attributes,V=L.attributes,k=0,K=F.getAttributes();for(let Y in K)if(K[Y].location>=0){let te=O[Y],le=V[Y];if(le===void 0&&(Y==="instanceMatrix"&&E.instanceMatrix&&(le=E.instanceMatrix),Y==="instanceColor"&&E.instanceColor&&(le=E.instanceColor)),te===void 0||te.attribute!==le||le&&te.data!==le.data)return!0;k++}return r.attributesNum!==k||r.index!==I}function g(E,L,F,I){let O={},V=L.attributes,k=0,K=F.getAttributes();for(let Y in K)if(K[Y].location>=0){let te=V[Y];te===void 0&&(Y==="instanceMatrix"&&E.instanceMatrix&&(te=E.instanceMatrix),Y==="instanceColor"&&E.instanceColor&&(te=E.instanceColor));let le={};le.attribute=te,te&&te.data&&(le.data=te.data),O[Y]=le,k++}r.attributes=O,r.attributesNum=k,r.index=I}function x(){let E=r.newAttributes;for(let L=0,F=E.length;L<F;L++)E[L]=0}function f(E){p(E,0)}function p(E,L){let F=r.newAttributes,I=r.enabledAttributes,O=r.attributeDivisors;F[E]=1,I[E]===0&&(n.enableVertexAttribArray(E),I[E]=1),O[E]!==L&&(n.vertexAttribDivisor(E,L),O[E]=L)}function M(){let E=r.newAttributes,L=r.enabledAttributes;for(let F=0,I=L.length;F<I;F++)L[F]!==E[F]&&(n.disableVertexAttribArray(F),L[F]=0)}function P(E,L,F,I,O,V,k){k===!0?n.vertexAttribIPointer(E,L,F,O,V):n.vertexAttribPointer(E,L,F,I,O,V)}function y(E,L,F,I){x();let O=I.attributes,V=F.getAttributes(),k=L.defaultAttributeValues;for(let K in V){let Y=V[K];if(Y.location>=0){let Z=O[K];if(Z===void 0&&(K==="instanceMatrix"&&E.instanceMatrix&&(Z=E.instanceMatrix),K==="instanceColor"&&E.instanceColor&&(Z=E.instanceColor)),Z!==void 0){let te=Z.normalized,le=Z.itemSize,ce=e.get(Z);if(ce===void 0)continue;let ee=ce.buffer,me=ce.type,_e=ce.bytesPerElement,oe=me===n.INT||me===n.UNSIGNED_INT||Z.gpuType===th;if(Z.isInterleavedBufferAttribute){let de=Z.data,Ne=de.isInterleavedBuffer===!0?de.stride:de.itemSize,$e=Z.offset;if(de.isInstancedInterleavedBuffer||de.isInstancedBufferAttribute){for(let Be=0;Be<Y.locationSize;Be++)p(Y.location+Be,de.meshPerAttribute);E.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=de.meshPerAttribute*de.count)}else for(let Be=0;Be<Y.locationSize;Be++)f(Y.location+Be);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Be=0;Be<Y.locationSize;Be++)P(Y.location+Be,le/Y.locationSize,me,te,Ne*_e,($e+le/Y.locationSize*Be)*_e,oe)}else{if(Z.isInstancedBufferAttribute){for(let de=0;de<Y.locationSize;de++)p(Y.location+de,Z.meshPerAttribute);E.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=Z.meshPerAttribute*Z.count)}else for(let de=0;de<Y.locationSize;de++)f(Y.location+de);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let de=0;de<Y.locationSize;de++)P(Y.location+de,le/Y.locationSize,me,te,le*_e,le/Y.locationSize*de*_e,oe)}}else if(k!==void 0){let te=k[K];if(te!==void 0)switch(te.length){case 2:n.vertexAttrib2fv(Y.location,te);break;case 3:n.vertexAttrib3fv(Y.location,te);break;case 4:n.vertexAttrib4fv(Y.location,te);break;default:n.vertexAttrib1fv(Y.location,te)}}}}M()}function A(){D();for(let E in i){let L=i[E];for(let F in L){let I=L[F];for(let O in I){let V=I[O];for(let k in V)h(V[k].object),delete V[k];delete I[O]}}delete i[E]}}function b(E){if(i[E.id]===void 0)return;let L=i[E.id];for(let F in L){let I=L[F];for(let O in I){let V=I[O];for(let k in V)h(V[k].object),delete V[k];delete I[O]}}delete i[E.id]}function _(E){for(let L in i){let F=i[L];for(let I in F){let O=F[I];if(O[E.id]===void 0)continue;let V=O[E.id];for(let k in V)h(V[k].object),delete V[k];delete O[E.id]}}}function v(E){for(let L in i){let F=i[L],I=E.isInstancedMesh===!0?E.id:0,O=F[I];if(O!==void 0){for(let V in O){let k=O[V];for(let K in k)h(k[K].object),delete k[K];delete O[V]}delete F[I],Object.keys(F).length===0&&delete i[L]}}}function D(){C(),o=!0,r!==s&&(r=s,c(r.object))}function C(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:D,resetDefaultState:C,dispose:A,releaseStatesOfGeometry:b,releaseStatesOfObject:v,releaseStatesOfProgram:_,initAttributes:x,enableAttribute:f,disableUnusedAttributes:M}}function I1(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,h){h!==0&&(n.drawArraysInstanced(i,l,c,h),t.update(c,i,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let u=0;for(let m=0;m<h;m++)u+=c[m];t.update(u,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function L1(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let _=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==Xi&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let v=_===Wi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(_!==si&&_!==Hi&&!v&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(je("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),u=t.logarithmicDepthBuffer===!0&&d===!1;t.reversedDepthBuffer===!0&&d===!1&&je("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&d===!0&&je("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let m=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),f=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),M=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),P=n.getParameter(n.MAX_VARYING_VECTORS),y=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),A=n.getParameter(n.MAX_SAMPLES),b=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:m,maxVertexTextures:g,maxTextureSize:x,maxCubemapSize:f,maxAttributes:p,maxVertexUniforms:M,maxVaryings:P,maxFragmentUniforms:y,maxSamples:A,samples:b}}function D1(n){let e=this,t=null,i=0,s=!1,r=!1,o=new gi,a=new rt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let m=d.length!==0||u||i!==0||s;return s=u,i=d.length,m},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,u){t=h(d,u,0)},this.setState=function(d,u,m){let g=d.clippingPlanes,x=d.clipIntersection,f=d.clipShadows,p=n.get(d);if(!s||g===null||g.length===0||r&&!f)r?h(null):c();else{let M=r?0:i,P=M*4,y=p.clippingState||null;l.value=y,y=h(g,u,P,m);for(let A=0;A!==P;++A)y[A]=t[A];p.clippingState=y,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=M}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function h(d,u,m,g){let x=d!==null?d.length:0,f=null;if(x!==0){if(f=l.value,g!==!0||f===null){let p=m+x*4,M=u.matrixWorldInverse;a.getNormalMatrix(M),(f===null||f.length<p)&&(f=new Float32Array(p));for(let P=0,y=m;P!==x;++P,y+=4)o.copy(d[P]).applyMatrix4(M,a),o.normal.toArray(f,y),f[y+3]=o.constant}l.value=f,l.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,f}}var hl=class extends _i{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Na(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Js(5,5,5),r=new Ti({name:"CubemapFromEquirect",uniforms:Or(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ti,blending:Dr});r.uniforms.tEquirect.value=t;let o=new zn(s,r),a=t.minFilter;return t.minFilter===Cs&&(t.minFilter=Kn),new ko(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},W0=256,N1=3,U1=20,f_=256,p_=16,F1=3,O1=new X,B1=new ht,Vh=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ko(1,10,null),this._boxMesh=new zn(new Js(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=O1}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,u=l.autoClearColor,m=l.autoClearDepth,g=l.autoClearStencil,x=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(e.background=l.getClearColor(B1));let f=new ko(i,s,h);return f.position.copy(a),f.update(l,e),l.autoClear=d,l.autoClearColor=u,l.autoClearDepth=m,l.autoClearStencil=g,e.background=x,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Y0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=q0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(W0,pf(e))}_fromTexture(e,t){e.mapping===Ur||e.mapping===Ho?this._setSize(e.image.length===0?W0:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=X0(e,!1,!1),i=Math.log2(e)-N1;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=X0(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Ur||e.mapping===Ho?(this._cubemapMaterial===null&&(this._cubemapMaterial=Y0()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=q0()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=k1(),this._integrationMaterial=z1());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/p_);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-F1)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(f_*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=V1());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function X0(n,e,t){return new hl(n,{minFilter:Cs,generateMipmaps:e,type:Wi,colorSpace:wa,depthBuffer:t})}function ul(n,e,t){return new Ti({name:n,uniforms:e,vertexShader:ft.cube_vert,fragmentShader:t,side:ti,blending:Dr,depthTest:!1,depthWrite:!1})}function k1(){return ul("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${f_}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function z1(){return ul("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:p_}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function V1(){return ul("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${U1}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function q0(){return ul("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Y0(){return ul("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function G1(n){let e=new WeakMap,t=new WeakMap,i=null;function s(u,m=!1){return u==null?null:m?o(u):r(u)}function r(u){if(u&&u.isTexture){let m=u.mapping;if(m===Kc||m===Qc)if(e.has(u)){let g=e.get(u).texture;return a(g,u.mapping)}else{let g=u.image;if(g&&g.height>0){let x=new hl(g.height);return x.fromEquirectangularTexture(n,u),e.set(u,x),u.addEventListener("dispose",c),a(x.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let m=u.mapping,g=m===Kc||m===Qc,x=m===Ur||m===Ho;if(g||x){let f=t.get(u),p=f!==void 0?f.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==p)return i===null&&(i=new Vh(n)),f=g?i.fromEquirectangular(u,f):i.fromCubemap(u,f),f.texture.pmremVersion=u.pmremVersion,t.set(u,f),f.texture;if(f!==void 0)return f.texture;{let M=u.image;return g&&M&&M.height>0||x&&M&&l(M)?(i===null&&(i=new Vh(n)),f=g?i.fromEquirectangular(u):i.fromCubemap(u),f.texture.pmremVersion=u.pmremVersion,t.set(u,f),u.addEventListener("dispose",h),f.texture):null}}}return u}function a(u,m){return m===Kc?u.mapping=Ur:m===Qc&&(u.mapping=Ho),u}function l(u){let m=0,g=6;for(let x=0;x<g;x++)u[x]!==void 0&&m++;return m===g}function c(u){let m=u.target;m.removeEventListener("dispose",c);let g=e.get(m);g!==void 0&&(e.delete(m),g.dispose())}function h(u){let m=u.target;m.removeEventListener("dispose",h);let g=t.get(m);g!==void 0&&(t.delete(m),g.dispose())}function d(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:d}}function H1(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&va("WebGLRenderer: "+i+" extension not supported."),s}}}function W1(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let f in g.attributes)e.remove(g.attributes[f]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let x=r.get(g);x&&(e.remove(x),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),t.memory.geometries++),x}function h(g){let x=g.attributes;for(let f in x)e.update(x[f],n.ARRAY_BUFFER)}function d(g){let x=g.index,f=g.attributes.position,p=0;if(f===void 0)return;let M=x!==null?x.array.length:f.array.length/3-1,P=f.count>=65535?La:Ia,y=new P(Math.ceil(M/3)*6,1),A=y.array;if(x!==null){let _=x.array;p=x.version;for(let v=0,D=0;v<M;v+=3){let C=_[v+0],E=_[v+1],L=_[v+2];A[D++]=C,A[D++]=E,A[D++]=E,A[D++]=L,A[D++]=L,A[D++]=C}}else{p=f.version;for(let _=0,v=0;_<M;_+=3){let D=_+0,C=_+1,E=_+2;A[v++]=D,A[v++]=C,A[v++]=C,A[v++]=E,A[v++]=E,A[v++]=D}}y.version=p;let b=r.get(g);b&&e.remove(b),r.set(g,y)}function u(g){let x=r.get(g);if(x){let f=g.index;f!==null&&x.version<f.version&&d(g)}else d(g);return r.get(g)}function m(){for(let g in s){let x=s[g].deref();x!==void 0&&l(x)}}return{get:c,update:h,getWireframeAttribute:u,dispose:m}}function X1(n,e,t){let i;function s(d){i=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,u){n.drawElements(i,u,r,d*o),t.update(u,i,1)}function c(d,u,m){m!==0&&(n.drawElementsInstanced(i,u,r,d*o,m),t.update(u,i,m))}function h(d,u,m){if(m===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,u,0,r,d,0,m);let x=0;for(let f=0;f<m;f++)x+=u[f];t.update(x,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function q1(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:it("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function Y1(n,e,t){let i=new WeakMap,s=new Dt;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=h!==void 0?h.length:0,u=i.get(a);if(u===void 0||u.count!==d){let D=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",D)};u!==void 0&&u.texture.dispose();let m=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,f=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],M=a.morphAttributes.color||[],P=0;m===!0&&(P=1),g===!0&&(P=2),x===!0&&(P=3);let y=a.attributes.position.count*P,A=1;y>e.maxTextureSize&&(A=Math.ceil(y/e.maxTextureSize),y=e.maxTextureSize);let b=new Float32Array(y*A*4*d),_=new Ra(b,y,A,d);_.type=Hi,_.needsUpdate=!0;let v=P*4;for(let C=0;C<d;C++){let E=f[C],L=p[C],F=M[C],I=y*A*4*C;for(let O=0;O<E.count;O++){let V=O*v;m===!0&&(s.fromBufferAttribute(E,O),b[I+V+0]=s.x,b[I+V+1]=s.y,b[I+V+2]=s.z,b[I+V+3]=0),g===!0&&(s.fromBufferAttribute(L,O),b[I+V+4]=s.x,b[I+V+5]=s.y,b[I+V+6]=s.z,b[I+V+7]=0),x===!0&&(s.fromBufferAttribute(F,O),b[I+V+8]=s.x,b[I+V+9]=s.y,b[I+V+10]=s.z,b[I+V+11]=F.itemSize===4?s.w:1)}}u={count:d,texture:_,size:new Ke(y,A)},i.set(a,u),a.addEventListener("dispose",D)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let m=0;for(let x=0;x<c.length;x++)m+=c[x];let g=a.morphTargetsRelative?1:1-m;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",u.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",u.size)}return{update:r}}function $1(n,e,t,i,s){let r=new WeakMap;function o(c){let h=s.render.frame,d=c.geometry,u=e.get(c,d);if(r.get(u)!==h&&(e.update(u),r.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let m=c.skeleton;r.get(m)!==h&&(m.update(),r.set(m,h))}return u}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var Z1={[qd]:"LINEAR_TONE_MAPPING",[Yd]:"REINHARD_TONE_MAPPING",[$d]:"CINEON_TONE_MAPPING",[Zd]:"ACES_FILMIC_TONE_MAPPING",[Jd]:"AGX_TONE_MAPPING",[Kd]:"NEUTRAL_TONE_MAPPING",[jd]:"CUSTOM_TONE_MAPPING"};function j1(n,e,t,i,s,r){let o=new _i(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new ii;h.setAttribute("position",new Ht([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Ht([0,2,0,0,2,0],2));let d=new Fc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),u=new zn(h,d),m=new qa(-1,1,1,-1,0,1),g=null,x=null,f=!1,p,M=null,P=[],y=!1;this.setSize=function(A,b){o.setSize(A,b),a!==null&&a.setSize(A,b),l!==null&&l.setSize(A,b);for(let _=0;_<P.length;_++){let v=P[_];v.setSize&&v.setSize(A,b)}},this.setEffects=function(A){P=A,y=P.length>0&&P[0].isRenderPass===!0;let b=o.width,_=o.height;P.length>0&&a===null&&(a=new _i(b,_,{type:Wi,depthBuffer:!1,stencilBuffer:!1}),l=new _i(b,_,{type:Wi,depthBuffer:!1,stencilBuffer:!1}));let v=s===!0&&P.some(D=>D.needsDepthTexture===!0);v!==(o.depthTexture!==null)&&(v===!0&&c===null&&(c=new Rs(b,_),r===!0&&(c.format=Ps,c.type=Fr)),o.dispose(),o.depthTexture=v?c:null,o.resolveDepthBuffer=v,o.storeMultisampledDepthBuffer=v);for(let D=0;D<P.length;D++){let C=P[D];C.setSize&&C.setSize(b,_),v&&C.needsDepthTexture===!0&&C.setDepthTexture&&C.setDepthTexture(c)}},this.begin=function(A,b){if(f||A.toneMapping===as&&P.length===0)return!1;if(M=b,b!==null){let _=b.width,v=b.height;(o.width!==_||o.height!==v)&&this.setSize(_,v)}return y===!1&&A.setRenderTarget(o),p=A.toneMapping,A.toneMapping=as,!0},this.hasRenderPass=function(){return y},this.end=function(A,b){A.toneMapping=p,f=!0;let _=o,v=a;for(let D=0;D<P.length;D++){let C=P[D];C.enabled!==!1&&(C.render(A,v,_,b),C.needsSwap!==!1&&(_=v,v=v===a?l:a))}if(g!==A.outputColorSpace||x!==A.toneMapping){g=A.outputColorSpace,x=A.toneMapping,d.defines={},vt.getTransfer(g)===Lt&&(d.defines.SRGB_TRANSFER="");let D=Z1[x];D&&(d.defines[D]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=_.texture,A.setRenderTarget(M),A.render(u,m),M=null,f=!1},this.isCompositing=function(){return f},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),d.dispose()}}var m_=new ei,g_=new Rs(1,1),__=new Fa(1),x_=new Ra,y_=new Ac,v_=new Na,$0=[],Z0=[],j0=new Float32Array(16),J0=new Float32Array(9),K0=new Float32Array(4);function qo(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=$0[s];if(r===void 0&&(r=new Float32Array(s),$0[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Sn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Mn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Hh(n,e){let t=Z0[e];t===void 0&&(t=new Int32Array(e),Z0[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function J1(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function K1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;n.uniform2fv(this.addr,e),Mn(t,e)}}function Q1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Sn(t,e))return;n.uniform3fv(this.addr,e),Mn(t,e)}}function ew(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;n.uniform4fv(this.addr,e),Mn(t,e)}}function tw(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Sn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Mn(t,e)}else{if(Sn(t,i))return;K0.set(i),n.uniformMatrix2fv(this.addr,!1,K0),Mn(t,i)}}function nw(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Sn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Mn(t,e)}else{if(Sn(t,i))return;J0.set(i),n.uniformMatrix3fv(this.addr,!1,J0),Mn(t,i)}}function iw(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Sn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Mn(t,e)}else{if(Sn(t,i))return;j0.set(i),n.uniformMatrix4fv(this.addr,!1,j0),Mn(t,i)}}function sw(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function rw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;n.uniform2iv(this.addr,e),Mn(t,e)}}function ow(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Sn(t,e))return;n.uniform3iv(this.addr,e),Mn(t,e)}}function aw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;n.uniform4iv(this.addr,e),Mn(t,e)}}function lw(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function cw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;n.uniform2uiv(this.addr,e),Mn(t,e)}}function hw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Sn(t,e))return;n.uniform3uiv(this.addr,e),Mn(t,e)}}function uw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;n.uniform4uiv(this.addr,e),Mn(t,e)}}function Wh(n){return n.version===0&&(n.compareFunction=hf,n.needsUpdate=!0),n}function dw(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Wh(g_):r=m_,t.setTexture2D(e||r,s)}function fw(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||y_,s)}function pw(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Wh(__):r=v_,t.setTextureCube(e||r,s)}function mw(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||x_,s)}function gw(n){switch(n){case 5126:return J1;case 35664:return K1;case 35665:return Q1;case 35666:return ew;case 35674:return tw;case 35675:return nw;case 35676:return iw;case 5124:case 35670:return sw;case 35667:case 35671:return rw;case 35668:case 35672:return ow;case 35669:case 35673:return aw;case 5125:return lw;case 36294:return cw;case 36295:return hw;case 36296:return uw;case 35678:case 36198:case 36298:case 36306:case 35682:return dw;case 35679:case 36299:case 36307:return fw;case 35680:case 36300:case 36308:case 36293:return pw;case 36289:case 36303:case 36311:case 36292:return mw}}function _w(n,e){n.uniform1fv(this.addr,e)}function xw(n,e){let t=qo(e,this.size,2);n.uniform2fv(this.addr,t)}function yw(n,e){let t=qo(e,this.size,3);n.uniform3fv(this.addr,t)}function vw(n,e){let t=qo(e,this.size,4);n.uniform4fv(this.addr,t)}function Sw(n,e){let t=qo(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function Mw(n,e){let t=qo(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function bw(n,e){let t=qo(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function ww(n,e){n.uniform1iv(this.addr,e)}function Ew(n,e){n.uniform2iv(this.addr,e)}function Tw(n,e){n.uniform3iv(this.addr,e)}function Aw(n,e){n.uniform4iv(this.addr,e)}function Rw(n,e){n.uniform1uiv(this.addr,e)}function Cw(n,e){n.uniform2uiv(this.addr,e)}function Pw(n,e){n.uniform3uiv(this.addr,e)}function Iw(n,e){n.uniform4uiv(this.addr,e)}function Lw(n,e,t){let i=this.cache,s=e.length,r=Hh(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Wh(g_):o=m_;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function Dw(n,e,t){let i=this.cache,s=e.length,r=Hh(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||y_,r[o])}function Nw(n,e,t){let i=this.cache,s=e.length,r=Hh(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Wh(__):o=v_;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function Uw(n,e,t){let i=this.cache,s=e.length,r=Hh(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||x_,r[o])}function Fw(n){switch(n){case 5126:return _w;case 35664:return xw;case 35665:return yw;case 35666:return vw;case 35674:return Sw;case 35675:return Mw;case 35676:return bw;case 5124:case 35670:return ww;case 35667:case 35671:return Ew;case 35668:case 35672:return Tw;case 35669:case 35673:return Aw;case 5125:return Rw;case 36294:return Cw;case 36295:return Pw;case 36296:return Iw;case 35678:case 36198:case 36298:case 36306:case 35682:return Lw;case 35679:case 36299:case 36307:return Dw;case 35680:case 36300:case 36308:case 36293:return Nw;case 36289:case 36303:case 36311:case 36292:return Uw}}var Rf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=gw(t.type)}},Cf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Fw(t.type)}},Pf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},Tf=/(\w+)(\])?(\[|\.)?/g;function Q0(n,e){n.seq.push(e),n.map[e.id]=e}function Ow(n,e,t){let i=n.name,s=i.length;for(Tf.lastIndex=0;;){let r=Tf.exec(i),o=Tf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Q0(t,c===void 0?new Rf(a,n,e):new Cf(a,n,e));break}else{let d=t.map[a];d===void 0&&(d=new Pf(a),Q0(t,d)),t=d}}}var Xo=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);Ow(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function e_(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var Bw=37297,kw=0;function zw(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var t_=new rt;function Vw(n){vt._getMatrix(t_,vt.workingColorSpace,n);let e=`mat3( ${t_.elements.map(t=>t.toFixed(4))} )`;switch(vt.getTransfer(n)){case Ea:return[e,"LinearTransferOETF"];case Lt:return[e,"sRGBTransferOETF"];default:return je("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function n_(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+zw(n.getShaderSource(e),a)}else return r}function Gw(n,e){let t=Vw(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Hw={[qd]:"Linear",[Yd]:"Reinhard",[$d]:"Cineon",[Zd]:"ACESFilmic",[Jd]:"AgX",[Kd]:"Neutral",[jd]:"Custom"};function Ww(n,e){let t=Hw[e];return t===void 0?(je("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var zh=new X;function Xw(){vt.getLuminanceCoefficients(zh);let n=zh.x.toFixed(4),e=zh.y.toFixed(4),t=zh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function qw(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(cl).join(`
`)}function Yw(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function $w(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function cl(n){return n!==""}function i_(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function s_(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var Zw=/^[ \t]*#include +<([\w\d./]+)>/gm;function If(n){return n.replace(Zw,jw)}function jw(n,e){let t=ft[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return If(t)}var Jw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function r_(n){return n.replace(Jw,Kw)}function Kw(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function o_(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var Qw={[Ka]:"SHADOWMAP_TYPE_PCF",[Vo]:"SHADOWMAP_TYPE_VSM"};function eE(n){return Qw[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var tE={[Ho]:"ENVMAP_MODE_REFRACTION"};function nE(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":tE[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var iE={[Xd]:"ENVMAP_BLENDING_MULTIPLY",[T0]:"ENVMAP_BLENDING_MIX",[A0]:"ENVMAP_BLENDING_ADD"};function sE(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":iE[n.combine]||"ENVMAP_BLENDING_NONE"}function rE(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=eE(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=nE(t),d=sE(t),u=qw(t),m=Yw(r),g=s.createProgram(),x,f,p=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(x=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m].filter(cl).join(`
`),x.length>0&&(x+=`
`),f=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m].filter(cl).join(`
`),f.length>0&&(f+=`
`)):(x=[o_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(cl).join(`
`),f=[o_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+d:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==as?"#define TONE_MAPPING":"",t.toneMapping!==as?ft.tonemapping_pars_fragment:"",t.toneMapping!==as?Ww("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ft.colorspace_pars_fragment,Gw("linearToOutputTexel",t.outputColorSpace),Xw(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(cl).join(`
`)),o=If(o),o=i_(o,t),o=s_(o,t),a=If(a),a=i_(a,t),a=s_(a,t),o=r_(o),a=r_(a),t.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,x=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,f=["#define varying in",t.glslVersion===df?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===df?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+f);let M=p+x+o,P=p+f+a,y=e_(s,s.VERTEX_SHADER,M),A=e_(s,s.FRAGMENT_SHADER,P);s.attachShader(g,y),s.attachShader(g,A),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function b(C){if(n.debug.checkShaderErrors){let E=s.getProgramInfoLog(g)||"",L=s.getShaderInfoLog(y)||"",F=s.getShaderInfoLog(A)||"",I=E.trim(),O=L.trim(),V=F.trim(),k=!0,K=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(k=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,y,A);else{let Y=n_(s,y,"vertex"),Z=n_(s,A,"fragment");it("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+I+`
`+Y+`
`+Z)}else I!==""?je("WebGLProgram: Program Info Log:",I):(O===""||V==="")&&(K=!1);K&&(C.diagnostics={runnable:k,programLog:I,vertexShader:{log:O,prefix:x},fragmentShader:{log:V,prefix:f}})}s.deleteShader(y),s.deleteShader(A),_=new Xo(s,g),v=$w(s,g)}let _;this.getUniforms=function(){return _===void 0&&b(this),_};let v;this.getAttributes=function(){return v===void 0&&b(this),v};let D=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return D===!1&&(D=s.getProgramParameter(g,Bw)),D},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=kw++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=y,this.fragmentShader=A,this}var oE=0,Lf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Df(e),t.set(e,i)),i}},Df=class{constructor(e){this.id=oE++,this.code=e,this.usedTimes=0}};function aE(n){return n===rr||n===sl||n===rl}function lE(n,e,t,i,s,r){let o=new Ca,a=new Lf,l=new Set,c=[],h=new Map,d=i.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function m(_){return l.add(_),_===0?"uv":`uv${_}`}function g(_,v,D,C,E,L){let F=C.fog,I=E.geometry,O=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?C.environment:null,V=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,k=e.get(_.envMap||O,V),K=u[_.type],Y=i.precision;_.precision!==null&&(Y=i.getMaxPrecision(_.precision),Y!==_.precision&&je("WebGLProgram.getParameters:",_.precision,"not supported, using",Y,"instead."));let Z=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,te=Z!==void 0?Z.length:0,le=0;I.morphAttributes.position!==void 0&&(le=1),I.morphAttributes.normal!==void 0&&(le=2),I.morphAttributes.color!==void 0&&(le=3);let ce,ee,me,_e;if(K){let Ce=ni[K];ce=Ce.vertexShader,ee=Ce.fragmentShader}else{ce=_.vertexShader,ee=_.fragmentShader;let Ce=a.getVertexShaderStage(_),ut=a.getFragmentShaderStage(_);a.update(_,Ce,ut),me=Ce.id,_e=ut.id}let oe=n.getRenderTarget(),de=n.state.buffers.depth.getReversed(),Ne=E.isInstancedMesh===!0,$e=E.isBatchedMesh===!0,Be=!!_.map,st=!!_.matcap,at=!!k,Xe=at&&k.isPMREMTexture===!0,St=!!_.aoMap,Ct=!!_.lightMap,Kt=!!_.bumpMap&&_.wireframe===!1,Et=!!_.normalMap,wn=!!_.displacementMap,Mt=!!_.emissiveMap,_n=!!_.metalnessMap,Qt=!!_.roughnessMap,an=_.anisotropy>0,H=_.clearcoat>0,Pe=_.diffuseRoughness>0,Je=_.dispersion>0,lt=_.retroreflectivity>0,Ee=_.iridescence>0,kt=_.sheen>0,We=_.transmission>0,Ze=an&&!!_.anisotropyMap,N=H&&!!_.clearcoatMap,w=H&&!!_.clearcoatNormalMap,$=H&&!!_.clearcoatRoughnessMap,pe=Pe&&!!_.diffuseRoughnessMap,he=Ee&&!!_.iridescenceMap,ve=Ee&&!!_.iridescenceThicknessMap,Se=kt&&!!_.sheenColorMap,ie=kt&&!!_.sheenRoughnessMap,re=!!_.specularMap,xe=!!_.specularColorMap,G=!!_.specularIntensityMap,ae=We&&!!_.transmissionMap,se=We&&!!_.thicknessMap,Te=!!_.gradientMap,ye=!!_.alphaMap,we=_.alphaTest>0,qe=!!_.alphaHash,et=!!_.extensions,fe=as;_.toneMapped&&(oe===null||oe.isXRRenderTarget===!0)&&(fe=n.toneMapping);let Ve=Xe?k.isCompressedCubeTexture?k.image[0].mipmaps:k.mipmaps:null,tt={shaderID:K,shaderType:_.type,shaderName:_.name,vertexShader:ce,fragmentShader:ee,defines:_.defines,customVertexShaderID:me,customFragmentShaderID:_e,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:Y,batching:$e,batchingColor:$e&&E._colorsTexture!==null,instancing:Ne,instancingColor:Ne&&E.instanceColor!==null,instancingMorph:Ne&&E.morphTexture!==null,outputColorSpace:oe===null?n.outputColorSpace:oe.isXRRenderTarget===!0?oe.texture.colorSpace:vt.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Be,matcap:st,envMap:at,envMapMode:at&&k.mapping,envMapPMREM:Xe,envMapMaxLod:Xe?Ve.length-1:null,envMapSize:Xe?Ve[0].width:null,aoMap:St,lightMap:Ct,bumpMap:Kt,normalMap:Et,displacementMap:wn,emissiveMap:Mt,normalMapObjectSpace:Et&&_.normalMapType===P0,normalMapTangentSpace:Et&&_.normalMapType===Oh,packedNormalMap:Et&&_.normalMapType===Oh&&aE(_.normalMap.format),metalnessMap:_n,roughnessMap:Qt,anisotropy:an,anisotropyMap:Ze,clearcoat:H,clearcoatMap:N,clearcoatNormalMap:w,clearcoatRoughnessMap:$,diffuseRoughness:Pe,diffuseRoughnessMap:pe,dispersion:Je,retroreflection:lt,iridescence:Ee,iridescenceMap:he,iridescenceThicknessMap:ve,sheen:kt,sheenColorMap:Se,sheenRoughnessMap:ie,specularMap:re,specularColorMap:xe,specularIntensityMap:G,transmission:We,transmissionMap:ae,thicknessMap:se,gradientMap:Te,opaque:_.transparent===!1&&_.blending===Go&&_.alphaToCoverage===!1,alphaMap:ye,alphaTest:we,alphaHash:qe,combine:_.combine,mapUv:Be&&m(_.map.channel),aoMapUv:St&&m(_.aoMap.channel),lightMapUv:Ct&&m(_.lightMap.channel),bumpMapUv:Kt&&m(_.bumpMap.channel),normalMapUv:Et&&m(_.normalMap.channel),displacementMapUv:wn&&m(_.displacementMap.channel),emissiveMapUv:Mt&&m(_.emissiveMap.channel),metalnessMapUv:_n&&m(_.metalnessMap.channel),roughnessMapUv:Qt&&m(_.roughnessMap.channel),anisotropyMapUv:Ze&&m(_.anisotropyMap.channel),clearcoatMapUv:N&&m(_.clearcoatMap.channel),clearcoatNormalMapUv:w&&m(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&m(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:pe&&m(_.diffuseRoughnessMap.channel),iridescenceMapUv:he&&m(_.iridescenceMap.channel),iridescenceThicknessMapUv:ve&&m(_.iridescenceThicknessMap.channel),sheenColorMapUv:Se&&m(_.sheenColorMap.channel),sheenRoughnessMapUv:ie&&m(_.sheenRoughnessMap.channel),specularMapUv:re&&m(_.specularMap.channel),specularColorMapUv:xe&&m(_.specularColorMap.channel),specularIntensityMapUv:G&&m(_.specularIntensityMap.channel),transmissionMapUv:ae&&m(_.transmissionMap.channel),thicknessMapUv:se&&m(_.thicknessMap.channel),alphaMapUv:ye&&m(_.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(Et||an),vertexNormals:!!I.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:E.isPoints===!0&&!!I.attributes.uv&&(Be||ye),fog:!!F,useFog:_.fog===!0,fogExp2:!!F&&F.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||I.attributes.normal===void 0&&Et===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:de,skinning:E.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:le,numSunLights:v.sun.length,numDirLights:v.directional.length,numPointLights:v.point.length,numSpotLights:v.spot.length,numSpotLightMaps:v.spotLightMap.length,numRectAreaLights:v.rectArea.length,numHemiLights:v.hemi.length,numSunLightShadows:v.sunShadowMap.length,numDirLightShadows:v.directionalShadowMap.length,numPointLightShadows:v.pointShadowMap.length,numSpotLightShadows:v.spotShadowMap.length,numSpotLightShadowsWithMaps:v.numSpotLightShadowsWithMaps,numLightProbes:v.numLightProbes,numLightProbeGrids:L.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&D.length>0,shadowMapType:n.shadowMap.type,toneMapping:fe,decodeVideoTexture:Be&&_.map.isVideoTexture===!0&&vt.getTransfer(_.map.colorSpace)===Lt,decodeVideoTextureEmissive:Mt&&_.emissiveMap.isVideoTexture===!0&&vt.getTransfer(_.emissiveMap.colorSpace)===Lt,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===os,flipSided:_.side===ti,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:et&&_.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(et&&_.extensions.multiDraw===!0||$e)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return tt.vertexUv1s=l.has(1),tt.vertexUv2s=l.has(2),tt.vertexUv3s=l.has(3),l.clear(),tt}function x(_){let v=[];if(_.shaderID?v.push(_.shaderID):(v.push(_.customVertexShaderID),v.push(_.customFragmentShaderID)),_.defines!==void 0)for(let D in _.defines)v.push(D),v.push(_.defines[D]);return _.isRawShaderMaterial===!1&&(f(v,_),p(v,_),v.push(n.outputColorSpace)),v.push(_.customProgramCacheKey),v.join()}function f(_,v){_.push(v.precision),_.push(v.outputColorSpace),_.push(v.envMapMode),_.push(v.envMapPMREM),_.push(v.envMapMaxLod),_.push(v.envMapSize),_.push(v.mapUv),_.push(v.alphaMapUv),_.push(v.lightMapUv),_.push(v.aoMapUv),_.push(v.bumpMapUv),_.push(v.normalMapUv),_.push(v.displacementMapUv),_.push(v.emissiveMapUv),_.push(v.metalnessMapUv),_.push(v.roughnessMapUv),_.push(v.anisotropyMapUv),_.push(v.clearcoatMapUv),_.push(v.clearcoatNormalMapUv),_.push(v.clearcoatRoughnessMapUv),_.push(v.diffuseRoughnessMapUv),_.push(v.iridescenceMapUv),_.push(v.iridescenceThicknessMapUv),_.push(v.sheenColorMapUv),_.push(v.sheenRoughnessMapUv),_.push(v.specularMapUv),_.push(v.specularColorMapUv),_.push(v.specularIntensityMapUv),_.push(v.transmissionMapUv),_.push(v.thicknessMapUv),_.push(v.combine),_.push(v.fogExp2),_.push(v.sizeAttenuation),_.push(v.morphTargetsCount),_.push(v.numSunLights),_.push(v.numDirLights),_.push(v.numPointLights),_.push(v.numSpotLights),_.push(v.numSpotLightMaps),_.push(v.numHemiLights),_.push(v.numRectAreaLights),_.push(v.numSunLightShadows),_.push(v.numDirLightShadows),_.push(v.numPointLightShadows),_.push(v.numSpotLightShadows),_.push(v.numSpotLightShadowsWithMaps),_.push(v.numLightProbes),_.push(v.numLightProbeGrids),_.push(v.shadowMapType),_.push(v.toneMapping),_.push(v.numClippingPlanes),_.push(v.numClipIntersection),_.push(v.depthPacking)}function p(_,v){o.disableAll(),v.instancing&&o.enable(0),v.instancingColor&&o.enable(1),v.instancingMorph&&o.enable(2),v.matcap&&o.enable(3),v.envMap&&o.enable(4),v.normalMapObjectSpace&&o.enable(5),v.normalMapTangentSpace&&o.enable(6),v.clearcoat&&o.enable(7),v.iridescence&&o.enable(8),v.alphaTest&&o.enable(9),v.vertexColors&&o.enable(10),v.vertexAlphas&&o.enable(11),v.vertexUv1s&&o.enable(12),v.vertexUv2s&&o.enable(13),v.vertexUv3s&&o.enable(14),v.vertexTangents&&o.enable(15),v.anisotropy&&o.enable(16),v.alphaHash&&o.enable(17),v.batching&&o.enable(18),v.dispersion&&o.enable(19),v.retroreflection&&o.enable(24),v.diffuseRoughness&&o.enable(25),v.batchingColor&&o.enable(20),v.gradientMap&&o.enable(21),v.packedNormalMap&&o.enable(22),v.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),v.fog&&o.enable(0),v.useFog&&o.enable(1),v.flatShading&&o.enable(2),v.logarithmicDepthBuffer&&o.enable(3),v.reversedDepthBuffer&&o.enable(4),v.skinning&&o.enable(5),v.morphTargets&&o.enable(6),v.morphNormals&&o.enable(7),v.morphColors&&o.enable(8),v.premultipliedAlpha&&o.enable(9),v.shadowMapEnabled&&o.enable(10),v.doubleSided&&o.enable(11),v.flipSided&&o.enable(12),v.useDepthPacking&&o.enable(13),v.dithering&&o.enable(14),v.transmission&&o.enable(15),v.sheen&&o.enable(16),v.opaque&&o.enable(17),v.pointsUvs&&o.enable(18),v.decodeVideoTexture&&o.enable(19),v.decodeVideoTextureEmissive&&o.enable(20),v.alphaToCoverage&&o.enable(21),v.numLightProbeGrids>0&&o.enable(22),v.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function M(_){let v=u[_.type],D;if(v){let C=ni[v];D=al.clone(C.uniforms)}else D=_.uniforms;return D}function P(_,v){let D=h.get(v);return D!==void 0?++D.usedTimes:(D=new rE(n,v,_,s),c.push(D),h.set(v,D)),D}function y(_){if(--_.usedTimes===0){let v=c.indexOf(_);c[v]=c[c.length-1],c.pop(),h.delete(_.cacheKey),_.destroy()}}function A(_){a.remove(_)}function b(){a.dispose()}return{getParameters:g,getProgramCacheKey:x,getUniforms:M,acquireProgram:P,releaseProgram:y,releaseShaderCache:A,programs:c,dispose:b}}function cE(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function hE(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function a_(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function l_(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(u){let m=0;return u.isInstancedMesh&&(m+=2),u.isSkinnedMesh&&(m+=1),m}function a(u,m,g,x,f,p){let M=n[e];return M===void 0?(M={id:u.id,object:u,geometry:m,material:g,materialVariant:o(u),groupOrder:x,renderOrder:u.renderOrder,z:f,group:p},n[e]=M):(M.id=u.id,M.object=u,M.geometry=m,M.material=g,M.materialVariant=o(u),M.groupOrder=x,M.renderOrder=u.renderOrder,M.z=f,M.group=p),e++,M}function l(u,m,g,x,f,p,M){M.reversedDepth===!0&&(f=-f);let P=a(u,m,g,x,f,p);g.transmission>0?i.push(P):g.transparent===!0?s.push(P):t.push(P)}function c(u,m,g,x,f,p){let M=a(u,m,g,x,f,p);g.transmission>0?i.unshift(M):g.transparent===!0?s.unshift(M):t.unshift(M)}function h(u,m){t.length>1&&t.sort(u||hE),i.length>1&&i.sort(m||a_),s.length>1&&s.sort(m||a_)}function d(){for(let u=e,m=n.length;u<m;u++){let g=n[u];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:d,sort:h}}function uE(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new l_,n.set(i,[o])):s>=r.length?(o=new l_,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function dE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new X,color:new ht};break;case"SpotLight":t={position:new X,direction:new X,color:new ht,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new X,color:new ht,distance:0,decay:0};break;case"HemisphereLight":t={direction:new X,skyColor:new ht,groundColor:new ht};break;case"RectAreaLight":t={color:new ht,position:new X,halfWidth:new X,halfHeight:new X};break}return n[e.id]=t,t}}}function fE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var pE=0;function mE(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function gE(n){let e=new dE,t=fE(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new X);let s=new X,r=new Ot,o=new Ot;function a(c){let h=0,d=0,u=0;for(let L=0;L<9;L++)i.probe[L].set(0,0,0);let m=0,g=0,x=0,f=0,p=0,M=0,P=0,y=0,A=0,b=0,_=0,v=0,D=0,C=0;c.sort(mE);for(let L=0,F=c.length;L<F;L++){let I=c[L],O=I.color,V=I.intensity,k=I.distance,K=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===rr?K=I.shadow.map.texture:K=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)h+=O.r*V,d+=O.g*V,u+=O.b*V;else if(I.isLightProbe){for(let Y=0;Y<9;Y++)i.probe[Y].addScaledVector(I.sh.coefficients[Y],V);C++}else if(I.isSunLight){let Y=e.get(I);if(Y.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Z=I.shadow,te=t.get(I);te.shadowIntensity=Z.intensity,te.shadowBias=Z.bias,te.shadowNormalBias=Z.normalBias,te.shadowRadius=Z.radius,te.shadowMapSize.copy(Z.mapSize).multiply(Z.getFrameExtents()),i.sunShadow[g]=te,i.sunShadowMap[g]=K;let le=Z.getViewportCount();for(let ce=0;ce<le;ce++)i.sunShadowMatrix[x+ce]=Z.getMatrix(ce),i.sunShadowCascade[x+ce]=Z._cascadeData[ce];x+=le,g++}i.sun[m]=Y,m++}else if(I.isDirectionalLight){let Y=e.get(I);if(Y.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Z=I.shadow,te=t.get(I);te.shadowIntensity=Z.intensity,te.shadowBias=Z.bias,te.shadowNormalBias=Z.normalBias,te.shadowRadius=Z.radius,te.shadowMapSize=Z.mapSize,i.directionalShadow[f]=te,i.directionalShadowMap[f]=K,i.directionalShadowMatrix[f]=I.shadow.matrix,A++}i.directional[f]=Y,f++}else if(I.isSpotLight){let Y=e.get(I);Y.position.setFromMatrixPosition(I.matrixWorld),Y.color.copy(O).multiplyScalar(V),Y.distance=k,Y.coneCos=Math.cos(I.angle),Y.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),Y.decay=I.decay,i.spot[M]=Y;let Z=I.shadow;if(I.map&&(i.spotLightMap[v]=I.map,v++,Z.updateMatrices(I),I.castShadow&&D++),i.spotLightMatrix[M]=Z.matrix,I.castShadow){let te=t.get(I);te.shadowIntensity=Z.intensity,te.shadowBias=Z.bias,te.shadowNormalBias=Z.normalBias,te.shadowRadius=Z.radius,te.shadowMapSize=Z.mapSize,i.spotShadow[M]=te,i.spotShadowMap[M]=K,_++}M++}else if(I.isRectAreaLight){let Y=e.get(I);Y.color.copy(O).multiplyScalar(V),Y.halfWidth.set(I.width*.5,0,0),Y.halfHeight.set(0,I.height*.5,0),i.rectArea[P]=Y,P++}else if(I.isPointLight){let Y=e.get(I);if(Y.color.copy(I.color).multiplyScalar(I.intensity),Y.distance=I.distance,Y.decay=I.decay,I.castShadow){let Z=I.shadow,te=t.get(I);te.shadowIntensity=Z.intensity,te.shadowBias=Z.bias,te.shadowNormalBias=Z.normalBias,te.shadowRadius=Z.radius,te.shadowMapSize=Z.mapSize,te.shadowCameraNear=Z.camera.near,te.shadowCameraFar=Z.camera.far,i.pointShadow[p]=te,i.pointShadowMap[p]=K,i.pointShadowMatrix[p]=I.shadow.matrix,b++}i.point[p]=Y,p++}else if(I.isHemisphereLight){let Y=e.get(I);Y.skyColor.copy(I.color).multiplyScalar(V),Y.groundColor.copy(I.groundColor).multiplyScalar(V),i.hemi[y]=Y,y++}}P>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ie.LTC_FLOAT_1,i.rectAreaLTC2=Ie.LTC_FLOAT_2):(i.rectAreaLTC1=Ie.LTC_HALF_1,i.rectAreaLTC2=Ie.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=d,i.ambient[2]=u;let E=i.hash;(E.sunLength!==m||E.directionalLength!==f||E.pointLength!==p||E.spotLength!==M||E.rectAreaLength!==P||E.hemiLength!==y||E.numSunShadows!==g||E.numDirectionalShadows!==A||E.numPointShadows!==b||E.numSpotShadows!==_||E.numSpotMaps!==v||E.numLightProbes!==C)&&(i.sun.length=m,i.directional.length=f,i.spot.length=M,i.rectArea.length=P,i.point.length=p,i.hemi.length=y,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=A,i.directionalShadowMap.length=A,i.directionalShadowMatrix.length=A,i.pointShadow.length=b,i.pointShadowMap.length=b,i.pointShadowMatrix.length=b,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+v-D,i.spotLightMap.length=v,i.numSpotLightShadowsWithMaps=D,i.numLightProbes=C,E.sunLength=m,E.directionalLength=f,E.pointLength=p,E.spotLength=M,E.rectAreaLength=P,E.hemiLength=y,E.numSunShadows=g,E.numDirectionalShadows=A,E.numPointShadows=b,E.numSpotShadows=_,E.numSpotMaps=v,E.numLightProbes=C,i.version=pE++)}function l(c,h){let d=0,u=0,m=0,g=0,x=0,f=0,p=h.matrixWorldInverse;for(let M=0,P=c.length;M<P;M++){let y=c[M];if(y.isSunLight){let A=i.sun[d];A.direction.setFromMatrixPosition(y.matrixWorld),A.direction.transformDirection(p),d++}else if(y.isDirectionalLight){let A=i.directional[u];A.direction.setFromMatrixPosition(y.matrixWorld),s.setFromMatrixPosition(y.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(p),u++}else if(y.isSpotLight){let A=i.spot[g];A.position.setFromMatrixPosition(y.matrixWorld),A.position.applyMatrix4(p),A.direction.setFromMatrixPosition(y.matrixWorld),s.setFromMatrixPosition(y.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(p),g++}else if(y.isRectAreaLight){let A=i.rectArea[x];A.position.setFromMatrixPosition(y.matrixWorld),A.position.applyMatrix4(p),o.identity(),r.copy(y.matrixWorld),r.premultiply(p),o.extractRotation(r),A.halfWidth.set(y.width*.5,0,0),A.halfHeight.set(0,y.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),x++}else if(y.isPointLight){let A=i.point[m];A.position.setFromMatrixPosition(y.matrixWorld),A.position.applyMatrix4(p),m++}else if(y.isHemisphereLight){let A=i.hemi[f];A.direction.setFromMatrixPosition(y.matrixWorld),A.direction.transformDirection(p),f++}}}return{setup:a,setupView:l,state:i}}function c_(n){let e=new gE(n),t=[],i=[],s=[];function r(d){h.camera=d,t.length=0,i.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):t.push(d)}function a(d){i.push(d)}function l(){e.setup(t),s.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function c(d){e.setupView(t,d)}let h={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function _E(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new c_(n),e.set(s,[a])):r>=o.length?(a=new c_(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var xE=`void main() {
gl_Position = vec4( position, 1.0 );
}`,yE=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
const float samples = float( VSM_SAMPLES );
float mean = 0.0;
float squared_mean = 0.0;
float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
for ( float i = 0.0; i < samples; i ++ ) {
float uvOffset = uvStart + i * uvStride;
#ifdef HORIZONTAL_PASS
vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
mean += distribution.x;
squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
#else
float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
mean += depth;
squared_mean += depth * depth;
#endif
}
mean = mean / samples;
squared_mean = squared_mean / samples;
float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,vE=[new X(1,0,0),new X(-1,0,0),new X(0,1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1)],SE=[new X(0,-1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1),new X(0,-1,0),new X(0,-1,0)],h_=new Ot,ll=new X,Af=new X;function ME(n,e,t){let i=new js,s=new Ke,r=new Ke,o=new Dt,a=new Oc,l=new Bc,c={},h=t.maxTextureSize,d={[sr]:ti,[ti]:sr,[os]:os},u=new Ti({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ke},radius:{value:4}},vertexShader:xE,fragmentShader:yE}),m=u.clone();m.defines.HORIZONTAL_PASS=1;let g=new ii;g.setAttribute("position",new Bi(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new zn(g,u),f=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ka;let p=this.type;this.render=function(b,_,v){if(f.enabled===!1||f.autoUpdate===!1&&f.needsUpdate===!1||b.length===0)return;this.type===a0&&(je("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ka);let D=n.getRenderTarget(),C=n.getActiveCubeFace(),E=n.getActiveMipmapLevel(),L=n.state;L.setBlending(Dr),L.buffers.depth.getReversed()===!0?L.buffers.color.setClear(0,0,0,0):L.buffers.color.setClear(1,1,1,1),L.buffers.depth.setTest(!0),L.setScissorTest(!1);let F=p!==this.type;F&&_.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(O=>O.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,O=b.length;I<O;I++){let V=b[I],k=V.shadow;if(k===void 0){je("WebGLShadowMap:",V,"has no shadow.");continue}if(k.autoUpdate===!1&&k.needsUpdate===!1)continue;s.copy(k.mapSize);let K=k.getFrameExtents();s.multiply(K),r.copy(k.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/K.x),s.x=r.x*K.x,k.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/K.y),s.y=r.y*K.y,k.mapSize.y=r.y));let Y=n.state.buffers.depth.getReversed();if(k.camera._reversedDepth=Y,k.map===null||F===!0){if(k.map!==null&&(k.map.depthTexture!==null&&(k.map.depthTexture.dispose(),k.map.depthTexture=null),k.map.dispose()),this.type===Vo){if(V.isPointLight){je("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}k.map=new _i(s.x,s.y,{format:rr,type:Wi,minFilter:Kn,magFilter:Kn,generateMipmaps:!1}),k.map.texture.name=V.name+".shadowMap",k.map.depthTexture=new Rs(s.x,s.y,Hi),k.map.depthTexture.name=V.name+".shadowMapDepth",k.map.depthTexture.format=Ts,k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=gn,k.map.depthTexture.magFilter=gn}else V.isPointLight?(k.map=new hl(s.x),k.map.depthTexture=new Fa(s.x,Gi)):(k.map=new _i(s.x,s.y),k.map.depthTexture=new Rs(s.x,s.y,Gi)),k.map.depthTexture.name=V.name+".shadowMap",k.map.depthTexture.format=Ts,this.type===Ka?(k.map.depthTexture.compareFunction=Y?cf:lf,k.map.depthTexture.minFilter=Kn,k.map.depthTexture.magFilter=Kn):(k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=gn,k.map.depthTexture.magFilter=gn);k.camera.updateProjectionMatrix()}k.map.isWebGLCubeRenderTarget!==!0&&(k.map.width!==s.x||k.map.height!==s.y)&&k.map.setSize(s.x,s.y);let Z=k.map.isWebGLCubeRenderTarget?6:k.getViewportCount();V.isPointLight!==!0&&k.updateMatrices(V,v);let te=(k.camera.layers.mask&4294967294)!==0?k.camera.layers:v.layers;for(let le=0;le<Z;le++){let ce=k.getCamera(le);if(V.isPointLight){let ee=k.camera,me=k.matrix,_e=V.distance||ee.far;_e!==ee.far&&(ee.far=_e,ee.updateProjectionMatrix()),ll.setFromMatrixPosition(V.matrixWorld),ee.position.copy(ll),Af.copy(ee.position),Af.add(vE[le]),ee.up.copy(SE[le]),ee.lookAt(Af),ee.updateMatrixWorld(),me.makeTranslation(-ll.x,-ll.y,-ll.z),h_.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),k._frustum.setFromProjectionMatrix(h_,ee.coordinateSystem,ee.reversedDepth)}if(k.map.isWebGLCubeRenderTarget)n.setRenderTarget(k.map,le),n.clear();else{le===0&&(n.setRenderTarget(k.map),n.clear());let ee=k.getViewport(le);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),L.viewport(o)}i=k.getFrustum(le),y(_,v,ce,V,te,this.type)}k.isPointLightShadow!==!0&&this.type===Vo&&M(k,v),k.needsUpdate=!1}p=this.type,f.needsUpdate=!1,n.setRenderTarget(D,C,E)};function M(b,_){let v=e.update(x);u.defines.VSM_SAMPLES!==b.blurSamples&&(u.defines.VSM_SAMPLES=b.blurSamples,m.defines.VSM_SAMPLES=b.blurSamples,u.needsUpdate=!0,m.needsUpdate=!0),b.mapPass===null?b.mapPass=new _i(s.x,s.y,{format:rr,type:Wi}):(b.mapPass.width!==b.map.width||b.mapPass.height!==b.map.height)&&b.mapPass.setSize(b.map.width,b.map.height),u.uniforms.shadow_pass.value=b.map.depthTexture,u.uniforms.resolution.value.set(b.map.width,b.map.height),u.uniforms.radius.value=b.radius,n.setRenderTarget(b.mapPass),n.clear(),n.renderBufferDirect(_,null,v,u,x,null),m.uniforms.shadow_pass.value=b.mapPass.texture,m.uniforms.resolution.value.set(b.map.width,b.map.height),m.uniforms.radius.value=b.radius,n.setRenderTarget(b.map),n.clear(),n.renderBufferDirect(_,null,v,m,x,null)}function P(b,_,v,D){let C=null,E=v.isPointLight===!0?b.customDistanceMaterial:b.customDepthMaterial;if(E!==void 0)C=E;else if(C=v.isPointLight===!0?l:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let L=C.uuid,F=_.uuid,I=c[L];I===void 0&&(I={},c[L]=I);let O=I[F];O===void 0&&(O=C.clone(),I[F]=O,_.addEventListener("dispose",A)),C=O}if(C.visible=_.visible,C.wireframe=_.wireframe,D===Vo?C.side=_.shadowSide!==null?_.shadowSide:_.side:C.side=_.shadowSide!==null?_.shadowSide:d[_.side],C.alphaMap=_.alphaMap,C.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,C.map=_.map,C.clipShadows=_.clipShadows,C.clippingPlanes=_.clippingPlanes,C.clipIntersection=_.clipIntersection,C.displacementMap=_.displacementMap,C.displacementScale=_.displacementScale,C.displacementBias=_.displacementBias,C.wireframeLinewidth=_.wireframeLinewidth,C.linewidth=_.linewidth,v.isPointLight===!0&&C.isMeshDistanceMaterial===!0){let L=n.properties.get(C);L.light=v}return C}function y(b,_,v,D,C,E){if(b.visible===!1)return;if(b.layers.test(C)&&(b.isMesh||b.isLine||b.isPoints)&&(b.castShadow||b.receiveShadow&&E===Vo)&&(!b.frustumCulled||b.intersectsFrustum(i))){b.modelViewMatrix.multiplyMatrices(v.matrixWorldInverse,b.matrixWorld);let I=e.update(b),O=b.material;if(Array.isArray(O)){let V=I.groups;for(let k=0,K=V.length;k<K;k++){let Y=V[k],Z=O[Y.materialIndex];if(Z&&Z.visible){let te=P(b,Z,D,E);b.onBeforeShadow(n,b,_,v,I,te,Y),n.renderBufferDirect(v,null,I,te,b,Y),b.onAfterShadow(n,b,_,v,I,te,Y)}}}else if(O.visible){let V=P(b,O,D,E);b.onBeforeShadow(n,b,_,v,I,V,null),n.renderBufferDirect(v,null,I,V,b,null),b.onAfterShadow(n,b,_,v,I,V,null)}}let F=b.children;for(let I=0,O=F.length;I<O;I++)y(F[I],_,v,D,C,E)}function A(b){b.target.removeEventListener("dispose",A);for(let v in c){let D=c[v],C=b.target.uuid;C in D&&(D[C].dispose(),delete D[C])}}}function bE(n,e){function t(){let G=!1,ae=new Dt,se=null,Te=new Dt(0,0,0,0);return{setMask:function(ye){se!==ye&&!G&&(n.colorMask(ye,ye,ye,ye),se=ye)},setLocked:function(ye){G=ye},setClear:function(ye,we,qe,et,fe){fe===!0&&(ye*=et,we*=et,qe*=et),ae.set(ye,we,qe,et),Te.equals(ae)===!1&&(n.clearColor(ye,we,qe,et),Te.copy(ae))},reset:function(){G=!1,se=null,Te.set(-1,0,0,0)}}}function i(){let G=!1,ae=!1,se=null,Te=null,ye=null;return{setReversed:function(we){if(ae!==we){let qe=e.get("EXT_clip_control");we?qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.ZERO_TO_ONE_EXT):qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.NEGATIVE_ONE_TO_ONE_EXT),ae=we;let et=ye;ye=null,this.setClear(et)}},getReversed:function(){return ae},setTest:function(we){we?de(n.DEPTH_TEST):Ne(n.DEPTH_TEST)},setMask:function(we){se!==we&&!G&&(n.depthMask(we),se=we)},setFunc:function(we){if(ae&&(we=z0[we]),Te!==we){switch(we){case mc:n.depthFunc(n.NEVER);break;case gc:n.depthFunc(n.ALWAYS);break;case _c:n.depthFunc(n.LESS);break;case Io:n.depthFunc(n.LEQUAL);break;case xc:n.depthFunc(n.EQUAL);break;case yc:n.depthFunc(n.GEQUAL);break;case vc:n.depthFunc(n.GREATER);break;case Sc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Te=we}},setLocked:function(we){G=we},setClear:function(we){ye!==we&&(ye=we,ae&&(we=1-we),n.clearDepth(we))},reset:function(){G=!1,se=null,Te=null,ye=null,ae=!1}}}function s(){let G=!1,ae=null,se=null,Te=null,ye=null,we=null,qe=null,et=null,fe=null;return{setTest:function(Ve){G||(Ve?de(n.STENCIL_TEST):Ne(n.STENCIL_TEST))},setMask:function(Ve){ae!==Ve&&!G&&(n.stencilMask(Ve),ae=Ve)},setFunc:function(Ve,tt,Ce){(se!==Ve||Te!==tt||ye!==Ce)&&(n.stencilFunc(Ve,tt,Ce),se=Ve,Te=tt,ye=Ce)},setOp:function(Ve,tt,Ce){(we!==Ve||qe!==tt||et!==Ce)&&(n.stencilOp(Ve,tt,Ce),we=Ve,qe=tt,et=Ce)},setLocked:function(Ve){G=Ve},setClear:function(Ve){fe!==Ve&&(n.clearStencil(Ve),fe=Ve)},reset:function(){G=!1,ae=null,se=null,Te=null,ye=null,we=null,qe=null,et=null,fe=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,h={},d={},u={},m=new WeakMap,g=[],x=null,f=!1,p=null,M=null,P=null,y=null,A=null,b=null,_=null,v=new ht(0,0,0),D=0,C=!1,E=null,L=null,F=null,I=null,O=null,V=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),k=!1,K=0,Y=n.getParameter(n.VERSION);Y.indexOf("WebGL")!==-1?(K=parseFloat(/^WebGL (\d)/.exec(Y)[1]),k=K>=1):Y.indexOf("OpenGL ES")!==-1&&(K=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),k=K>=2);let Z=null,te={},le=n.getParameter(n.SCISSOR_BOX),ce=n.getParameter(n.VIEWPORT),ee=new Dt().fromArray(le),me=new Dt().fromArray(ce);function _e(G,ae,se,Te){let ye=new Uint8Array(4),we=n.createTexture();n.bindTexture(G,we),n.texParameteri(G,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(G,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let qe=0;qe<se;qe++)G===n.TEXTURE_3D||G===n.TEXTURE_2D_ARRAY?n.texImage3D(ae,0,n.RGBA,1,1,Te,0,n.RGBA,n.UNSIGNED_BYTE,ye):n.texImage2D(ae+qe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ye);return we}let oe={};oe[n.TEXTURE_2D]=_e(n.TEXTURE_2D,n.TEXTURE_2D,1),oe[n.TEXTURE_CUBE_MAP]=_e(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),oe[n.TEXTURE_2D_ARRAY]=_e(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),oe[n.TEXTURE_3D]=_e(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),de(n.DEPTH_TEST),o.setFunc(Io),Kt(!1),Et(kd),de(n.CULL_FACE),St(Dr);function de(G){h[G]!==!0&&(n.enable(G),h[G]=!0)}function Ne(G){h[G]!==!1&&(n.disable(G),h[G]=!1)}function $e(G,ae){return u[G]!==ae?(n.bindFramebuffer(G,ae),u[G]=ae,G===n.DRAW_FRAMEBUFFER&&(u[n.FRAMEBUFFER]=ae),G===n.FRAMEBUFFER&&(u[n.DRAW_FRAMEBUFFER]=ae),!0):!1}function Be(G,ae){let se=g,Te=!1;if(G){se=m.get(ae),se===void 0&&(se=[],m.set(ae,se));let ye=G.textures;if(se.length!==ye.length||se[0]!==n.COLOR_ATTACHMENT0){for(let we=0,qe=ye.length;we<qe;we++)se[we]=n.COLOR_ATTACHMENT0+we;se.length=ye.length,Te=!0}}else se[0]!==n.BACK&&(se[0]=n.BACK,Te=!0);Te&&n.drawBuffers(se)}function st(G){return x!==G?(n.useProgram(G),x=G,!0):!1}let at={[Nr]:n.FUNC_ADD,[c0]:n.FUNC_SUBTRACT,[h0]:n.FUNC_REVERSE_SUBTRACT};at[u0]=n.MIN,at[d0]=n.MAX;let Xe={[f0]:n.ZERO,[p0]:n.ONE,[m0]:n.SRC_COLOR,[Hd]:n.SRC_ALPHA,[S0]:n.SRC_ALPHA_SATURATE,[y0]:n.DST_COLOR,[_0]:n.DST_ALPHA,[g0]:n.ONE_MINUS_SRC_COLOR,[Wd]:n.ONE_MINUS_SRC_ALPHA,[v0]:n.ONE_MINUS_DST_COLOR,[x0]:n.ONE_MINUS_DST_ALPHA,[M0]:n.CONSTANT_COLOR,[b0]:n.ONE_MINUS_CONSTANT_COLOR,[w0]:n.CONSTANT_ALPHA,[E0]:n.ONE_MINUS_CONSTANT_ALPHA};function St(G,ae,se,Te,ye,we,qe,et,fe,Ve){if(G===Dr){f===!0&&(Ne(n.BLEND),f=!1);return}if(f===!1&&(de(n.BLEND),f=!0),G!==l0){if(G!==p||Ve!==C){if((M!==Nr||A!==Nr)&&(n.blendEquation(n.FUNC_ADD),M=Nr,A=Nr),Ve)switch(G){case Go:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case zd:n.blendFunc(n.ONE,n.ONE);break;case Vd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Gd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:it("WebGLState: Invalid blending: ",G);break}else switch(G){case Go:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case zd:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Vd:it("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Gd:it("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:it("WebGLState: Invalid blending: ",G);break}P=null,y=null,b=null,_=null,v.set(0,0,0),D=0,p=G,C=Ve}return}ye=ye||ae,we=we||se,qe=qe||Te,(ae!==M||ye!==A)&&(n.blendEquationSeparate(at[ae],at[ye]),M=ae,A=ye),(se!==P||Te!==y||we!==b||qe!==_)&&(n.blendFuncSeparate(Xe[se],Xe[Te],Xe[we],Xe[qe]),P=se,y=Te,b=we,_=qe),(et.equals(v)===!1||fe!==D)&&(n.blendColor(et.r,et.g,et.b,fe),v.copy(et),D=fe),p=G,C=!1}function Ct(G,ae){G.side===os?Ne(n.CULL_FACE):de(n.CULL_FACE);let se=G.side===ti;ae&&(se=!se),Kt(se),G.blending===Go&&G.transparent===!1?St(Dr):St(G.blending,G.blendEquation,G.blendSrc,G.blendDst,G.blendEquationAlpha,G.blendSrcAlpha,G.blendDstAlpha,G.blendColor,G.blendAlpha,G.premultipliedAlpha),o.setFunc(G.depthFunc),o.setTest(G.depthTest),o.setMask(G.depthWrite),r.setMask(G.colorWrite);let Te=G.stencilWrite;a.setTest(Te),Te&&(a.setMask(G.stencilWriteMask),a.setFunc(G.stencilFunc,G.stencilRef,G.stencilFuncMask),a.setOp(G.stencilFail,G.stencilZFail,G.stencilZPass)),Mt(G.polygonOffset,G.polygonOffsetFactor,G.polygonOffsetUnits),G.alphaToCoverage===!0?de(n.SAMPLE_ALPHA_TO_COVERAGE):Ne(n.SAMPLE_ALPHA_TO_COVERAGE)}function Kt(G){E!==G&&(G?n.frontFace(n.CW):n.frontFace(n.CCW),E=G)}function Et(G){G!==r0?(de(n.CULL_FACE),G!==L&&(G===kd?n.cullFace(n.BACK):G===o0?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ne(n.CULL_FACE),L=G}function wn(G){G!==F&&(k&&n.lineWidth(G),F=G)}function Mt(G,ae,se){G?(de(n.POLYGON_OFFSET_FILL),(I!==ae||O!==se)&&(I=ae,O=se,o.getReversed()&&(ae=-ae,se=-se),n.polygonOffset(ae,se))):Ne(n.POLYGON_OFFSET_FILL)}function _n(G){G?de(n.SCISSOR_TEST):Ne(n.SCISSOR_TEST)}function Qt(G){G===void 0&&(G=n.TEXTURE0+V-1),Z!==G&&(n.activeTexture(G),Z=G)}function an(G,ae,se){se===void 0&&(Z===null?se=n.TEXTURE0+V-1:se=Z);let Te=te[se];Te===void 0&&(Te={type:void 0,texture:void 0},te[se]=Te),(Te.type!==G||Te.texture!==ae)&&(Z!==se&&(n.activeTexture(se),Z=se),n.bindTexture(G,ae||oe[G]),Te.type=G,Te.texture=ae)}function H(){let G=te[Z];G!==void 0&&G.type!==void 0&&(n.bindTexture(G.type,null),G.type=void 0,G.texture=void 0)}function Pe(){try{n.compressedTexImage2D(...arguments)}catch(G){it("WebGLState:",G)}}function Je(){try{n.compressedTexImage3D(...arguments)}catch(G){it("WebGLState:",G)}}function lt(){try{n.texSubImage2D(...arguments)}catch(G){it("WebGLState:",G)}}function Ee(){try{n.texSubImage3D(...arguments)}catch(G){it("WebGLState:",G)}}function kt(){try{n.compressedTexSubImage2D(...arguments)}catch(G){it("WebGLState:",G)}}function We(){try{n.compressedTexSubImage3D(...arguments)}catch(G){it("WebGLState:",G)}}function Ze(){try{n.texStorage2D(...arguments)}catch(G){it("WebGLState:",G)}}function N(){try{n.texStorage3D(...arguments)}catch(G){it("WebGLState:",G)}}function w(){try{n.texImage2D(...arguments)}catch(G){it("WebGLState:",G)}}function $(){try{n.texImage3D(...arguments)}catch(G){it("WebGLState:",G)}}function pe(G){return d[G]!==void 0?d[G]:n.getParameter(G)}function he(G,ae){d[G]!==ae&&(n.pixelStorei(G,ae),d[G]=ae)}function ve(G){ee.equals(G)===!1&&(n.scissor(G.x,G.y,G.z,G.w),ee.copy(G))}function Se(G){me.equals(G)===!1&&(n.viewport(G.x,G.y,G.z,G.w),me.copy(G))}function ie(G,ae){let se=c.get(ae);se===void 0&&(se=new WeakMap,c.set(ae,se));let Te=se.get(G);Te===void 0&&(Te=n.getUniformBlockIndex(ae,G.name),n.uniformBlockBinding(ae,Te,Te),se.set(G,Te))}function re(G,ae,se){let ye=c.get(ae).get(G);l[ye]!==se&&(n.bindBufferBase(n.UNIFORM_BUFFER,ye,se),l[ye]=se)}function xe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},d={},Z=null,te={},u={},l={},m=new WeakMap,g=[],x=null,f=!1,p=null,M=null,P=null,y=null,A=null,b=null,_=null,v=new ht(0,0,0),D=0,C=!1,E=null,L=null,F=null,I=null,O=null,ee.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:de,disable:Ne,bindFramebuffer:$e,drawBuffers:Be,useProgram:st,setBlending:St,setMaterial:Ct,setFlipSided:Kt,setCullFace:Et,setLineWidth:wn,setPolygonOffset:Mt,setScissorTest:_n,activeTexture:Qt,bindTexture:an,unbindTexture:H,compressedTexImage2D:Pe,compressedTexImage3D:Je,texImage2D:w,texImage3D:$,pixelStorei:he,getParameter:pe,updateUBOMapping:ie,uniformBlockBinding:re,texStorage2D:Ze,texStorage3D:N,texSubImage2D:lt,texSubImage3D:Ee,compressedTexSubImage2D:kt,compressedTexSubImage3D:We,scissor:ve,viewport:Se,reset:xe}}function wE(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ke,h=new WeakMap,d=new Set,u,m=new WeakMap,g=new Set,x=new FinalizationRegistry(N=>g.delete(N)),f=!1;try{f=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(N,w){return f?new OffscreenCanvas(N,w):Ta("canvas")}function M(N,w,$){let pe=1,he=Ze(N);if((he.width>$||he.height>$)&&(pe=$/Math.max(he.width,he.height)),pe<1)if(typeof HTMLImageElement<"u"&&N instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&N instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&N instanceof ImageBitmap||typeof VideoFrame<"u"&&N instanceof VideoFrame){let ve=Math.floor(pe*he.width),Se=Math.floor(pe*he.height);u===void 0&&(u=p(ve,Se));let ie=w?p(ve,Se):u;return ie.width=ve,ie.height=Se,ie.getContext("2d").drawImage(N,0,0,ve,Se),je("WebGLRenderer: Texture has been resized from ("+he.width+"x"+he.height+") to ("+ve+"x"+Se+")."),ie}else return"data"in N&&je("WebGLRenderer: Image in DataTexture is too big ("+he.width+"x"+he.height+")."),N;return N}function P(N){return N.generateMipmaps}function y(N){n.generateMipmap(N)}function A(N){return N.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:N.isWebGL3DRenderTarget?n.TEXTURE_3D:N.isWebGLArrayRenderTarget||N.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function b(N,w,$,pe,he,ve=!1){if(N!==null){if(n[N]!==void 0)return n[N];je("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+N+"'")}let Se;pe&&(Se=e.get("EXT_texture_norm16"),Se||je("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ie=w;if(w===n.RED&&($===n.FLOAT&&(ie=n.R32F),$===n.HALF_FLOAT&&(ie=n.R16F),$===n.UNSIGNED_BYTE&&(ie=n.R8),$===n.UNSIGNED_SHORT&&Se&&(ie=Se.R16_EXT),$===n.SHORT&&Se&&(ie=Se.R16_SNORM_EXT)),w===n.RED_INTEGER&&($===n.UNSIGNED_BYTE&&(ie=n.R8UI),$===n.UNSIGNED_SHORT&&(ie=n.R16UI),$===n.UNSIGNED_INT&&(ie=n.R32UI),$===n.BYTE&&(ie=n.R8I),$===n.SHORT&&(ie=n.R16I),$===n.INT&&(ie=n.R32I)),w===n.RG&&($===n.FLOAT&&(ie=n.RG32F),$===n.HALF_FLOAT&&(ie=n.RG16F),$===n.UNSIGNED_BYTE&&(ie=n.RG8),$===n.UNSIGNED_SHORT&&Se&&(ie=Se.RG16_EXT),$===n.SHORT&&Se&&(ie=Se.RG16_SNORM_EXT)),w===n.RG_INTEGER&&($===n.UNSIGNED_BYTE&&(ie=n.RG8UI),$===n.UNSIGNED_SHORT&&(ie=n.RG16UI),$===n.UNSIGNED_INT&&(ie=n.RG32UI),$===n.BYTE&&(ie=n.RG8I),$===n.SHORT&&(ie=n.RG16I),$===n.INT&&(ie=n.RG32I)),w===n.RGB_INTEGER&&($===n.UNSIGNED_BYTE&&(ie=n.RGB8UI),$===n.UNSIGNED_SHORT&&(ie=n.RGB16UI),$===n.UNSIGNED_INT&&(ie=n.RGB32UI),$===n.BYTE&&(ie=n.RGB8I),$===n.SHORT&&(ie=n.RGB16I),$===n.INT&&(ie=n.RGB32I)),w===n.RGBA_INTEGER&&($===n.UNSIGNED_BYTE&&(ie=n.RGBA8UI),$===n.UNSIGNED_SHORT&&(ie=n.RGBA16UI),$===n.UNSIGNED_INT&&(ie=n.RGBA32UI),$===n.BYTE&&(ie=n.RGBA8I),$===n.SHORT&&(ie=n.RGBA16I),$===n.INT&&(ie=n.RGBA32I)),w===n.RGB&&($===n.UNSIGNED_SHORT&&Se&&(ie=Se.RGB16_EXT),$===n.SHORT&&Se&&(ie=Se.RGB16_SNORM_EXT),$===n.UNSIGNED_INT_5_9_9_9_REV&&(ie=n.RGB9_E5),$===n.UNSIGNED_INT_10F_11F_11F_REV&&(ie=n.R11F_G11F_B10F)),w===n.RGBA){let re=ve?Ea:vt.getTransfer(he);$===n.FLOAT&&(ie=n.RGBA32F),$===n.HALF_FLOAT&&(ie=n.RGBA16F),$===n.UNSIGNED_BYTE&&(ie=re===Lt?n.SRGB8_ALPHA8:n.RGBA8),$===n.UNSIGNED_SHORT&&Se&&(ie=Se.RGBA16_EXT),$===n.SHORT&&Se&&(ie=Se.RGBA16_SNORM_EXT),$===n.UNSIGNED_SHORT_4_4_4_4&&(ie=n.RGBA4),$===n.UNSIGNED_SHORT_5_5_5_1&&(ie=n.RGB5_A1)}return(ie===n.R16F||ie===n.R32F||ie===n.RG16F||ie===n.RG32F||ie===n.RGBA16F||ie===n.RGBA32F)&&e.get("EXT_color_buffer_float"),ie}function _(N,w){let $;return N?w===null||w===Gi||w===Fr?$=n.DEPTH24_STENCIL8:w===Hi?$=n.DEPTH32F_STENCIL8:w===Wo&&($=n.DEPTH24_STENCIL8,je("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Gi||w===Fr?$=n.DEPTH_COMPONENT24:w===Hi?$=n.DEPTH_COMPONENT32F:w===Wo&&($=n.DEPTH_COMPONENT16),$}function v(N,w){return P(N)===!0||N.isFramebufferTexture&&N.minFilter!==gn&&N.minFilter!==Kn?Math.log2(Math.max(w.width,w.height))+1:N.mipmaps.length>0?N.mipmaps.length:N.isCompressedTexture&&Array.isArray(N.image)?w.mipmaps.length:1}function D(N){let w=new WeakRef(N);i.get(N).__ref=w,g.add(w),x.register(N,w,w)}function C(N){let w=i.get(N).__ref;w!==void 0&&(g.delete(w),x.unregister(w))}function E(N){F(N.target)}function L(N){I(N.target)}function F(N){N.removeEventListener("dispose",E),C(N),V(N),N.isVideoTexture&&h.delete(N),N.isHTMLTexture&&d.delete(N)}function I(N){N.removeEventListener("dispose",L),C(N),K(N)}function O(){for(let N of g){let w=N.deref();w!==void 0&&(w.isRenderTarget===!0?I(w):F(w))}g.clear(),d.clear()}function V(N){let w=i.get(N);if(w.__webglInit===void 0)return;let $=N.source,pe=m.get($);if(pe){let he=pe[w.__cacheKey];he.usedTimes--,he.usedTimes===0&&k(N),Object.keys(pe).length===0&&m.delete($)}i.remove(N)}function k(N){let w=i.get(N);n.deleteTexture(w.__webglTexture);let $=N.source,pe=m.get($);delete pe[w.__cacheKey],o.memory.textures--}function K(N){let w=i.get(N);w.__depthDisposeCallback&&w.__depthDisposeCallback();let $=N.depthTexture;if($&&$.renderTarget===N&&F($),N.isWebGLCubeRenderTarget)for(let he=0;he<6;he++){if(Array.isArray(w.__webglFramebuffer[he]))for(let ve=0;ve<w.__webglFramebuffer[he].length;ve++)n.deleteFramebuffer(w.__webglFramebuffer[he][ve]);else n.deleteFramebuffer(w.__webglFramebuffer[he]);w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer[he])}else{if(Array.isArray(w.__webglFramebuffer))for(let he=0;he<w.__webglFramebuffer.length;he++)n.deleteFramebuffer(w.__webglFramebuffer[he]);else n.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&n.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let he=0;he<w.__webglColorRenderbuffer.length;he++)w.__webglColorRenderbuffer[he]&&n.deleteRenderbuffer(w.__webglColorRenderbuffer[he]);w.__webglDepthRenderbuffer&&n.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let pe=N.textures;for(let he=0,ve=pe.length;he<ve;he++){let Se=i.get(pe[he]);Se.__webglTexture&&(n.deleteTexture(Se.__webglTexture),o.memory.textures--),i.remove(pe[he])}i.remove(N)}let Y=0;function Z(){Y=0}function te(){return Y}function le(N){Y=N}function ce(){let N=Y;return N>=s.maxTextures&&je("WebGLTextures: Trying to use "+(N+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,N}function ee(N){let w=[];return w.push(N.wrapS),w.push(N.wrapT),w.push(N.wrapR||0),w.push(N.magFilter),w.push(N.minFilter),w.push(N.anisotropy),w.push(N.internalFormat),w.push(N.format),w.push(N.type),w.push(N.generateMipmaps),w.push(N.mipmapsAutoUpdate),w.push(N.premultiplyAlpha),w.push(N.flipY),w.push(N.unpackAlignment),w.push(N.colorSpace),w.join()}function me(N,w){let $=i.get(N);if(N.isVideoTexture&&kt(N),N.isRenderTargetTexture===!1&&N.isExternalTexture!==!0&&N.version>0&&$.__version!==N.version){let pe=N.image;if(pe===null)je("WebGLRenderer: Texture marked for update but no image data found.");else if(pe.complete===!1)je("WebGLRenderer: Texture marked for update but image is incomplete");else{Ct($,N,w);return}}else N.isExternalTexture&&($.__webglTexture=N.sourceTexture?N.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,$.__webglTexture,n.TEXTURE0+w)}function _e(N,w){let $=i.get(N);if(N.isRenderTargetTexture===!1&&N.version>0&&$.__version!==N.version){Ct($,N,w);return}else N.isExternalTexture&&($.__webglTexture=N.sourceTexture?N.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,$.__webglTexture,n.TEXTURE0+w)}function oe(N,w){let $=i.get(N);if(N.isRenderTargetTexture===!1&&N.version>0&&$.__version!==N.version){Ct($,N,w);return}t.bindTexture(n.TEXTURE_3D,$.__webglTexture,n.TEXTURE0+w)}function de(N,w){let $=i.get(N);if(N.version>0&&$.__version!==N.version){Kt($,N,w);return}t.bindTexture(n.TEXTURE_CUBE_MAP,$.__webglTexture,n.TEXTURE0+w)}let Ne={[Mc]:n.REPEAT,[ss]:n.CLAMP_TO_EDGE,[bc]:n.MIRRORED_REPEAT},$e={[gn]:n.NEAREST,[R0]:n.NEAREST_MIPMAP_NEAREST,[Qa]:n.NEAREST_MIPMAP_LINEAR,[Kn]:n.LINEAR,[eh]:n.LINEAR_MIPMAP_NEAREST,[Cs]:n.LINEAR_MIPMAP_LINEAR},Be={[L0]:n.NEVER,[hf]:n.ALWAYS,[D0]:n.LESS,[lf]:n.LEQUAL,[N0]:n.EQUAL,[cf]:n.GEQUAL,[U0]:n.GREATER,[F0]:n.NOTEQUAL};function st(N,w){if(w.type===Hi&&e.has("OES_texture_float_linear")===!1&&(w.magFilter===Kn||w.magFilter===eh||w.magFilter===Qa||w.magFilter===Cs||w.minFilter===Kn||w.minFilter===eh||w.minFilter===Qa||w.minFilter===Cs)&&je("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(N,n.TEXTURE_WRAP_S,Ne[w.wrapS]),n.texParameteri(N,n.TEXTURE_WRAP_T,Ne[w.wrapT]),(N===n.TEXTURE_3D||N===n.TEXTURE_2D_ARRAY)&&n.texParameteri(N,n.TEXTURE_WRAP_R,Ne[w.wrapR]),n.texParameteri(N,n.TEXTURE_MAG_FILTER,$e[w.magFilter]),n.texParameteri(N,n.TEXTURE_MIN_FILTER,$e[w.minFilter]),w.compareFunction&&(n.texParameteri(N,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(N,n.TEXTURE_COMPARE_FUNC,Be[w.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===gn||w.minFilter!==Qa&&w.minFilter!==Cs||w.type===Hi&&e.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||i.get(w).__currentAnisotropy){let $=e.get("EXT_texture_filter_anisotropic");n.texParameterf(N,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),i.get(w).__currentAnisotropy=w.anisotropy}}}function at(N,w){let $=!1;N.__webglInit===void 0&&(N.__webglInit=!0,w.addEventListener("dispose",E),D(w));let pe=w.source,he=m.get(pe);he===void 0&&(he={},m.set(pe,he));let ve=ee(w);if(ve!==N.__cacheKey){he[ve]===void 0&&(he[ve]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,$=!0),he[ve].usedTimes++;let Se=he[N.__cacheKey];Se!==void 0&&(he[N.__cacheKey].usedTimes--,Se.usedTimes===0&&k(w)),N.__cacheKey=ve,N.__webglTexture=he[ve].texture}return $}function Xe(N,w,$){return Math.floor(Math.floor(N/$)/w)}function St(N,w,$,pe){let ve=N.updateRanges;if(ve.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,w.width,w.height,$,pe,w.data);else{ve.sort((G,ae)=>G.start-ae.start);let Se=0;for(let G=1;G<ve.length;G++){let ae=ve[Se],se=ve[G],Te=ae.start+ae.count,ye=Xe(se.start,w.width,4),we=Xe(ae.start,w.width,4);se.start<=Te+1&&ye===we&&Xe(se.start+se.count-1,w.width,4)===ye?ae.count=Math.max(ae.count,se.start+se.count-ae.start):(++Se,ve[Se]=se)}ve.length=Se+1;let ie=t.getParameter(n.UNPACK_ROW_LENGTH),re=t.getParameter(n.UNPACK_SKIP_PIXELS),xe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,w.width);for(let G=0,ae=ve.length;G<ae;G++){let se=ve[G],Te=Math.floor(se.start/4),ye=Math.ceil(se.count/4),we=Te%w.width,qe=Math.floor(Te/w.width),et=ye,fe=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,we),t.pixelStorei(n.UNPACK_SKIP_ROWS,qe),t.texSubImage2D(n.TEXTURE_2D,0,we,qe,et,fe,$,pe,w.data)}N.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,ie),t.pixelStorei(n.UNPACK_SKIP_PIXELS,re),t.pixelStorei(n.UNPACK_SKIP_ROWS,xe)}}function Ct(N,w,$){let pe=n.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(pe=n.TEXTURE_2D_ARRAY),w.isData3DTexture&&(pe=n.TEXTURE_3D);let he=at(N,w),ve=w.source;t.bindTexture(pe,N.__webglTexture,n.TEXTURE0+$);let Se=i.get(ve);if(ve.version!==Se.__version||he===!0){if(t.activeTexture(n.TEXTURE0+$),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let fe=vt.getPrimaries(vt.workingColorSpace),Ve=w.colorSpace===Is?null:vt.getPrimaries(w.colorSpace),tt=w.colorSpace===Is||fe===Ve?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,tt)}t.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment);let re=M(w.image,!1,s.maxTextureSize);re=We(w,re);let xe=r.convert(w.format,w.colorSpace),G=r.convert(w.type),ae=b(w.internalFormat,xe,G,w.normalized,w.colorSpace,w.isVideoTexture);st(pe,w);let se,Te=w.mipmaps,ye=w.isVideoTexture!==!0,we=Se.__version===void 0||he===!0,qe=ve.dataReady,et=v(w,re);if(w.isDepthTexture)ae=_(w.format===Ps,w.type),we&&(ye?t.texStorage2D(n.TEXTURE_2D,1,ae,re.width,re.height):t.texImage2D(n.TEXTURE_2D,0,ae,re.width,re.height,0,xe,G,null));else if(w.isDataTexture)if(Te.length>0){ye&&we&&t.texStorage2D(n.TEXTURE_2D,et,ae,Te[0].width,Te[0].height);for(let fe=0,Ve=Te.length;fe<Ve;fe++)se=Te[fe],ye?qe&&t.texSubImage2D(n.TEXTURE_2D,fe,0,0,se.width,se.height,xe,G,se.data):t.texImage2D(n.TEXTURE_2D,fe,ae,se.width,se.height,0,xe,G,se.data);w.generateMipmaps=!1}else ye?(we&&t.texStorage2D(n.TEXTURE_2D,et,ae,re.width,re.height),qe&&St(w,re,xe,G)):t.texImage2D(n.TEXTURE_2D,0,ae,re.width,re.height,0,xe,G,re.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){ye&&we&&t.texStorage3D(n.TEXTURE_2D_ARRAY,et,ae,Te[0].width,Te[0].height,re.depth);for(let fe=0,Ve=Te.length;fe<Ve;fe++)if(se=Te[fe],w.format!==Xi)if(xe!==null)if(ye){if(qe)if(w.layerUpdates.size>0){let tt=vf(se.width,se.height,w.format,w.type);for(let Ce of w.layerUpdates){let ut=se.data.subarray(Ce*tt/se.data.BYTES_PER_ELEMENT,(Ce+1)*tt/se.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,fe,0,0,Ce,se.width,se.height,1,xe,ut)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,fe,0,0,0,se.width,se.height,re.depth,xe,se.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,fe,ae,se.width,se.height,re.depth,0,se.data,0,0);else je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ye?qe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,fe,0,0,0,se.width,se.height,re.depth,xe,G,se.data):t.texImage3D(n.TEXTURE_2D_ARRAY,fe,ae,se.width,se.height,re.depth,0,xe,G,se.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{ye&&we&&t.texStorage2D(n.TEXTURE_2D,et,ae,Te[0].width,Te[0].height);for(let fe=0,Ve=Te.length;fe<Ve;fe++)se=Te[fe],w.format!==Xi?xe!==null?ye?qe&&t.compressedTexSubImage2D(n.TEXTURE_2D,fe,0,0,se.width,se.height,xe,se.data):t.compressedTexImage2D(n.TEXTURE_2D,fe,ae,se.width,se.height,0,se.data):je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ye?qe&&t.texSubImage2D(n.TEXTURE_2D,fe,0,0,se.width,se.height,xe,G,se.data):t.texImage2D(n.TEXTURE_2D,fe,ae,se.width,se.height,0,xe,G,se.data)}else if(w.isDataArrayTexture)if(ye){if(we&&t.texStorage3D(n.TEXTURE_2D_ARRAY,et,ae,re.width,re.height,re.depth),qe)if(w.layerUpdates.size>0){let fe=vf(re.width,re.height,w.format,w.type);for(let Ve of w.layerUpdates){let tt=re.data.subarray(Ve*fe/re.data.BYTES_PER_ELEMENT,(Ve+1)*fe/re.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ve,re.width,re.height,1,xe,G,tt)}w.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,re.width,re.height,re.depth,xe,G,re.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,ae,re.width,re.height,re.depth,0,xe,G,re.data);else if(w.isData3DTexture)ye?(we&&t.texStorage3D(n.TEXTURE_3D,et,ae,re.width,re.height,re.depth),qe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,re.width,re.height,re.depth,xe,G,re.data)):t.texImage3D(n.TEXTURE_3D,0,ae,re.width,re.height,re.depth,0,xe,G,re.data);else if(w.isFramebufferTexture){if(we)if(ye)t.texStorage2D(n.TEXTURE_2D,et,ae,re.width,re.height);else{let fe=re.width,Ve=re.height;for(let tt=0;tt<et;tt++)t.texImage2D(n.TEXTURE_2D,tt,ae,fe,Ve,0,xe,G,null),fe>>=1,Ve>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in n){let fe=n.canvas;if(fe.hasAttribute("layoutsubtree")||fe.setAttribute("layoutsubtree","true"),re.parentNode!==fe){fe.appendChild(re),d.add(w),fe.onpaint=Ve=>{let tt=Ve.changedElements;for(let Ce of d)tt.includes(Ce.image)&&(Ce.needsUpdate=!0)},fe.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,re);else{let tt=n.RGBA,Ce=n.RGBA,ut=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,tt,Ce,ut,re)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Te.length>0){if(ye&&we){let fe=Ze(Te[0]);t.texStorage2D(n.TEXTURE_2D,et,ae,fe.width,fe.height)}for(let fe=0,Ve=Te.length;fe<Ve;fe++)se=Te[fe],ye?qe&&t.texSubImage2D(n.TEXTURE_2D,fe,0,0,xe,G,se):t.texImage2D(n.TEXTURE_2D,fe,ae,xe,G,se);w.generateMipmaps=!1}else if(ye){if(we){let fe=Ze(re);t.texStorage2D(n.TEXTURE_2D,et,ae,fe.width,fe.height)}qe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,xe,G,re)}else t.texImage2D(n.TEXTURE_2D,0,ae,xe,G,re);P(w)&&w.mipmapsAutoUpdate===!0&&y(pe),Se.__version=ve.version,w.onUpdate&&w.onUpdate(w)}N.__version=w.version}function Kt(N,w,$){if(w.image.length!==6)return;let pe=at(N,w),he=w.source;t.bindTexture(n.TEXTURE_CUBE_MAP,N.__webglTexture,n.TEXTURE0+$);let ve=i.get(he);if(he.version!==ve.__version||pe===!0){t.activeTexture(n.TEXTURE0+$);let Se=vt.getPrimaries(vt.workingColorSpace),ie=w.colorSpace===Is?null:vt.getPrimaries(w.colorSpace),re=w.colorSpace===Is||Se===ie?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,re);let xe=w.isCompressedTexture||w.image[0].isCompressedTexture,G=w.image[0]&&w.image[0].isDataTexture,ae=[];for(let Ce=0;Ce<6;Ce++)!xe&&!G?ae[Ce]=M(w.image[Ce],!0,s.maxCubemapSize):ae[Ce]=G?w.image[Ce].image:w.image[Ce],ae[Ce]=We(w,ae[Ce]);let se=ae[0],Te=r.convert(w.format,w.colorSpace),ye=r.convert(w.type),we=b(w.internalFormat,Te,ye,w.normalized,w.colorSpace),qe=w.isVideoTexture!==!0,et=ve.__version===void 0||pe===!0,fe=he.dataReady,Ve=v(w,se);st(n.TEXTURE_CUBE_MAP,w);let tt;if(w.isDepthTexture){if(we=_(w.format===Ps,w.type),et)if(qe)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,we,se.width,se.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,we,se.width,se.height,0,Te,ye,null)}else if(xe){qe&&et&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Ve,we,se.width,se.height);for(let Ce=0;Ce<6;Ce++){tt=ae[Ce].mipmaps;for(let ut=0;ut<tt.length;ut++){let Wt=tt[ut];w.format!==Xi?Te!==null?qe?fe&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut,0,0,Wt.width,Wt.height,Te,Wt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut,we,Wt.width,Wt.height,0,Wt.data):je("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):qe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut,0,0,Wt.width,Wt.height,Te,ye,Wt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut,we,Wt.width,Wt.height,0,Te,ye,Wt.data)}}}else{if(tt=w.mipmaps,qe&&et){tt.length>0&&Ve++;let Ce=Ze(ae[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Ve,we,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(G){qe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,ae[Ce].width,ae[Ce].height,Te,ye,ae[Ce].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,we,ae[Ce].width,ae[Ce].height,0,Te,ye,ae[Ce].data);for(let ut=0;ut<tt.length;ut++){let Gn=tt[ut].image[Ce].image;qe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut+1,0,0,Gn.width,Gn.height,Te,ye,Gn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut+1,we,Gn.width,Gn.height,0,Te,ye,Gn.data)}}else{qe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,Te,ye,ae[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,we,Te,ye,ae[Ce]);for(let ut=0;ut<tt.length;ut++){let Wt=tt[ut];qe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut+1,0,0,Te,ye,Wt.image[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut+1,we,Te,ye,Wt.image[Ce])}}}P(w)&&w.mipmapsAutoUpdate===!0&&y(n.TEXTURE_CUBE_MAP),ve.__version=he.version,w.onUpdate&&w.onUpdate(w)}N.__version=w.version}function Et(N,w,$,pe,he,ve){let Se=r.convert($.format,$.colorSpace),ie=r.convert($.type),re=b($.internalFormat,Se,ie,$.normalized,$.colorSpace),xe=i.get(w),G=i.get($);if(G.__renderTarget=w,!xe.__hasExternalTextures){let ae=Math.max(1,w.width>>ve),se=Math.max(1,w.height>>ve);he===n.TEXTURE_3D||he===n.TEXTURE_2D_ARRAY?t.texImage3D(he,ve,re,ae,se,w.depth,0,Se,ie,null):t.texImage2D(he,ve,re,ae,se,0,Se,ie,null)}t.bindFramebuffer(n.FRAMEBUFFER,N),Ee(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,he,G.__webglTexture,0,lt(w)):(he===n.TEXTURE_2D||he>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&he<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,pe,he,G.__webglTexture,ve),t.bindFramebuffer(n.FRAMEBUFFER,null)}function wn(N,w,$){if(n.bindRenderbuffer(n.RENDERBUFFER,N),w.depthBuffer){let pe=w.depthTexture,he=pe&&pe.isDepthTexture?pe.type:null,ve=_(w.stencilBuffer,he),Se=w.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Ee(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,lt(w),ve,w.width,w.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,lt(w),ve,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,ve,w.width,w.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Se,n.RENDERBUFFER,N)}else{let pe=w.textures;for(let he=0;he<pe.length;he++){let ve=pe[he],Se=r.convert(ve.format,ve.colorSpace),ie=r.convert(ve.type),re=b(ve.internalFormat,Se,ie,ve.normalized,ve.colorSpace);Ee(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,lt(w),re,w.width,w.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,lt(w),re,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,re,w.width,w.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Mt(N,w,$){let pe=w.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,N),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let he=i.get(w.depthTexture);he.__renderTarget=w;let ve=pe?w.depthTexture.image[0]:w.depthTexture.image;(!he.__webglTexture||ve.width!==w.width||ve.height!==w.height)&&(ve.width=w.width,ve.height=w.height,w.depthTexture.needsUpdate=!0),pe?de(w.depthTexture,0):me(w.depthTexture,0);let Se=he.__webglTexture,ie=lt(w),re=pe?n.TEXTURE_CUBE_MAP_POSITIVE_X+$:n.TEXTURE_2D,xe=w.depthTexture.format===Ps?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(w.depthTexture.format===Ts)Ee(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,xe,re,Se,0,ie):n.framebufferTexture2D(n.FRAMEBUFFER,xe,re,Se,0);else if(w.depthTexture.format===Ps)Ee(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,xe,re,Se,0,ie):n.framebufferTexture2D(n.FRAMEBUFFER,xe,re,Se,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function _n(N){let w=i.get(N),$=N.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==N.depthTexture){let pe=N.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),pe){let he=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,pe.removeEventListener("dispose",he)};pe.addEventListener("dispose",he),w.__depthDisposeCallback=he}w.__boundDepthTexture=pe}if(N.depthTexture&&!w.__autoAllocateDepthBuffer)if($)for(let pe=0;pe<6;pe++)Mt(w.__webglFramebuffer[pe],N,pe);else N.texture.mipmaps.length>0?Mt(w.__webglFramebuffer[0],N,0):Mt(w.__webglFramebuffer,N,0);else if($){w.__webglDepthbuffer=[];for(let pe=0;pe<6;pe++)if(t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[pe]),w.__webglDepthbuffer[pe]===void 0)w.__webglDepthbuffer[pe]=n.createRenderbuffer(),wn(w.__webglDepthbuffer[pe],N,!1);else{let he=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=w.__webglDepthbuffer[pe];n.bindRenderbuffer(n.RENDERBUFFER,ve),n.framebufferRenderbuffer(n.FRAMEBUFFER,he,n.RENDERBUFFER,ve)}}else if(N.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=n.createRenderbuffer(),wn(w.__webglDepthbuffer,N,!1);else{let he=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=w.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,ve),n.framebufferRenderbuffer(n.FRAMEBUFFER,he,n.RENDERBUFFER,ve)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function Qt(N,w,$){let pe=i.get(N);w!==void 0&&Et(pe.__webglFramebuffer,N,N.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),$!==void 0&&_n(N)}function an(N){let w=N.texture,$=i.get(N),pe=i.get(w);N.addEventListener("dispose",L),D(N);let he=N.textures,ve=N.isWebGLCubeRenderTarget===!0,Se=he.length>1;if(Se||(pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture()),pe.__version=w.version,o.memory.textures++),ve){$.__webglFramebuffer=[];for(let ie=0;ie<6;ie++)if(w.mipmaps.length>0){$.__webglFramebuffer[ie]=[];for(let re=0;re<w.mipmaps.length;re++)$.__webglFramebuffer[ie][re]=n.createFramebuffer()}else $.__webglFramebuffer[ie]=n.createFramebuffer()}else{if(w.mipmaps.length>0){$.__webglFramebuffer=[];for(let ie=0;ie<w.mipmaps.length;ie++)$.__webglFramebuffer[ie]=n.createFramebuffer()}else $.__webglFramebuffer=n.createFramebuffer();if(Se)for(let ie=0,re=he.length;ie<re;ie++){let xe=i.get(he[ie]);xe.__webglTexture===void 0&&(xe.__webglTexture=n.createTexture(),o.memory.textures++)}if(N.samples>0&&Ee(N)===!1){$.__webglMultisampledFramebuffer=n.createFramebuffer(),$.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let ie=0;ie<he.length;ie++){let re=he[ie];$.__webglColorRenderbuffer[ie]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,$.__webglColorRenderbuffer[ie]);let xe=r.convert(re.format,re.colorSpace),G=r.convert(re.type),ae=b(re.internalFormat,xe,G,re.normalized,re.colorSpace,N.isXRRenderTarget===!0),se=lt(N);n.renderbufferStorageMultisample(n.RENDERBUFFER,se,ae,N.width,N.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ie,n.RENDERBUFFER,$.__webglColorRenderbuffer[ie])}n.bindRenderbuffer(n.RENDERBUFFER,null),N.depthBuffer&&($.__webglDepthRenderbuffer=n.createRenderbuffer(),wn($.__webglDepthRenderbuffer,N,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ve){t.bindTexture(n.TEXTURE_CUBE_MAP,pe.__webglTexture),st(n.TEXTURE_CUBE_MAP,w);for(let ie=0;ie<6;ie++)if(w.mipmaps.length>0)for(let re=0;re<w.mipmaps.length;re++)Et($.__webglFramebuffer[ie][re],N,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ie,re);else Et($.__webglFramebuffer[ie],N,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ie,0);P(w)?y(n.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}else if(Se){for(let ie=0,re=he.length;ie<re;ie++){let xe=he[ie],G=i.get(xe),ae=n.TEXTURE_2D;(N.isWebGL3DRenderTarget||N.isWebGLArrayRenderTarget)&&(ae=N.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ae,G.__webglTexture),st(ae,xe),Et($.__webglFramebuffer,N,xe,n.COLOR_ATTACHMENT0+ie,ae,0),P(xe)&&y(ae)}t.unbindTexture()}else{let ie=n.TEXTURE_2D;if((N.isWebGL3DRenderTarget||N.isWebGLArrayRenderTarget)&&(ie=N.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ie,pe.__webglTexture),st(ie,w),w.mipmaps.length>0)for(let re=0;re<w.mipmaps.length;re++)Et($.__webglFramebuffer[re],N,w,n.COLOR_ATTACHMENT0,ie,re);else Et($.__webglFramebuffer,N,w,n.COLOR_ATTACHMENT0,ie,0);P(w)?y(ie):w.mipmaps.length>0&&n.texParameteri(ie,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}N.depthBuffer&&_n(N)}function H(N){let w=N.textures;for(let $=0,pe=w.length;$<pe;$++){let he=w[$];if(P(he)&&he.mipmapsAutoUpdate===!0){let ve=A(N),Se=i.get(he).__webglTexture;t.bindTexture(ve,Se),y(ve),t.unbindTexture()}}}let Pe=[];function Je(N){if(N.samples>0){if(Ee(N)===!1){let w=N.textures,$=N.width,pe=N.height,he=n.COLOR_BUFFER_BIT,ve=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Se=i.get(N),ie=w.length>1;if(ie)for(let xe=0;xe<w.length;xe++)t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,Se.__webglMultisampledFramebuffer),N.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglFramebuffer);for(let xe=0;xe<w.length;xe++){if(N.resolveDepthBuffer&&(N.depthBuffer&&(he|=n.DEPTH_BUFFER_BIT),N.stencilBuffer&&N.resolveStencilBuffer&&(he|=n.STENCIL_BUFFER_BIT)),ie){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Se.__webglColorRenderbuffer[xe]);let G=i.get(w[xe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,G,0)}n.blitFramebuffer(0,0,$,pe,0,0,$,pe,he,n.NEAREST),l===!0&&(Pe.length=0,Pe.push(n.COLOR_ATTACHMENT0+xe),N.depthBuffer&&N.storeMultisampledDepthBuffer===!1&&Pe.push(ve),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Pe))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ie)for(let xe=0;xe<w.length;xe++){t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.RENDERBUFFER,Se.__webglColorRenderbuffer[xe]);let G=i.get(w[xe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.TEXTURE_2D,G,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglMultisampledFramebuffer)}else if(N.depthBuffer&&N.storeMultisampledDepthBuffer===!1&&l){let w=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[w])}}}function lt(N){return Math.min(s.maxSamples,N.samples)}function Ee(N){let w=i.get(N);return N.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function kt(N){let w=o.render.frame;h.get(N)!==w&&(h.set(N,w),N.update())}function We(N,w){let $=N.colorSpace,pe=N.format,he=N.type;return N.isCompressedTexture===!0||N.isVideoTexture===!0||$!==wa&&$!==Is&&(vt.getTransfer($)===Lt?(pe!==Xi||he!==si)&&je("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):it("WebGLTextures: Unsupported texture color space:",$)),w}function Ze(N){return typeof HTMLImageElement<"u"&&N instanceof HTMLImageElement?(c.width=N.naturalWidth||N.width,c.height=N.naturalHeight||N.height):typeof VideoFrame<"u"&&N instanceof VideoFrame?(c.width=N.displayWidth,c.height=N.displayHeight):(c.width=N.width,c.height=N.height),c}this.allocateTextureUnit=ce,this.resetTextureUnits=Z,this.getTextureUnits=te,this.setTextureUnits=le,this.setTexture2D=me,this.setTexture2DArray=_e,this.setTexture3D=oe,this.setTextureCube=de,this.rebindTextures=Qt,this.setupRenderTarget=an,this.updateRenderTargetMipmap=H,this.updateMultisampleRenderTarget=Je,this.setupDepthRenderbuffer=_n,this.setupFrameBufferTexture=Et,this.useMultisampledRTT=Ee,this.dispose=O}function EE(n,e){function t(i,s=Is){let r,o=vt.getTransfer(s);if(i===si)return n.UNSIGNED_BYTE;if(i===nh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===ih)return n.UNSIGNED_SHORT_5_5_5_1;if(i===nf)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===sf)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===ef)return n.BYTE;if(i===tf)return n.SHORT;if(i===Wo)return n.UNSIGNED_SHORT;if(i===th)return n.INT;if(i===Gi)return n.UNSIGNED_INT;if(i===Hi)return n.FLOAT;if(i===Wi)return n.HALF_FLOAT;if(i===rf)return n.ALPHA;if(i===of)return n.RGB;if(i===Xi)return n.RGBA;if(i===Ts)return n.DEPTH_COMPONENT;if(i===Ps)return n.DEPTH_STENCIL;if(i===af)return n.RED;if(i===sh)return n.RED_INTEGER;if(i===rr)return n.RG;if(i===rh)return n.RG_INTEGER;if(i===oh)return n.RGBA_INTEGER;if(i===el||i===tl||i===nl||i===il)if(o===Lt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===el)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===tl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===nl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===il)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===el)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===tl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===nl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===il)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===ah||i===lh||i===ch||i===hh)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===ah)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===lh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===ch)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===hh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===uh||i===dh||i===fh||i===ph||i===mh||i===sl||i===gh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===uh||i===dh)return o===Lt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===fh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===ph)return r.COMPRESSED_R11_EAC;if(i===mh)return r.COMPRESSED_SIGNED_R11_EAC;if(i===sl)return r.COMPRESSED_RG11_EAC;if(i===gh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===_h||i===xh||i===yh||i===vh||i===Sh||i===Mh||i===bh||i===wh||i===Eh||i===Th||i===Ah||i===Rh||i===Ch||i===Ph)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===_h)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===xh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===yh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===vh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Sh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Mh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===bh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===wh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Eh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Th)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Ah)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Rh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Ch)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Ph)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Ih||i===Lh||i===Dh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Ih)return o===Lt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Lh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Dh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Nh||i===Uh||i===rl||i===Fh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Nh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Uh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===rl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Fh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Fr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var TE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,AE=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Nf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Oa(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Ti({vertexShader:TE,fragmentShader:AE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new zn(new Lr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Uf=class extends ki{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,d=null,u=null,m=null,g=null,x=typeof XRWebGLBinding<"u",f=new Nf,p={},M=t.getContextAttributes(),P=null,y=null,A=[],b=[],_=new Ke,v=null,D=null,C=new jn;C.viewport=new Dt;let E=new jn;E.viewport=new Dt;let L=[C,E],F=new jc,I=null,O=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let me=A[ee];return me===void 0&&(me=new Fo,A[ee]=me),me.getTargetRaySpace()},this.getControllerGrip=function(ee){let me=A[ee];return me===void 0&&(me=new Fo,A[ee]=me),me.getGripSpace()},this.getHand=function(ee){let me=A[ee];return me===void 0&&(me=new Fo,A[ee]=me),me.getHandSpace()};function V(ee){let me=b.indexOf(ee.inputSource);if(me===-1)return;let _e=A[me];_e!==void 0&&(_e.update(ee.inputSource,ee.frame,c||o),_e.dispatchEvent({type:ee.type,data:ee.inputSource}))}function k(){s.removeEventListener("select",V),s.removeEventListener("selectstart",V),s.removeEventListener("selectend",V),s.removeEventListener("squeeze",V),s.removeEventListener("squeezestart",V),s.removeEventListener("squeezeend",V),s.removeEventListener("end",k),s.removeEventListener("inputsourceschange",K);for(let ee=0;ee<A.length;ee++){let me=b[ee];me!==null&&(b[ee]=null,A[ee].disconnect(me))}I=null,O=null,f.reset();for(let ee in p)delete p[ee];if(e.setRenderTarget(P),m=null,u=null,d=null,s=null,y=null,ce.stop(),i.isPresenting=!1,e.setPixelRatio(v),e.setSize(_.width,_.height,!1),D!==null){let ee=D.camera;ee.fov=D.fov,ee.zoom=D.zoom,ee.updateProjectionMatrix(),D=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&je("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&je("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return u!==null?u:m},this.getBinding=function(){return d===null&&x&&(d=new XRWebGLBinding(s,t)),d},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(P=e.getRenderTarget(),s.addEventListener("select",V),s.addEventListener("selectstart",V),s.addEventListener("selectend",V),s.addEventListener("squeeze",V),s.addEventListener("squeezestart",V),s.addEventListener("squeezeend",V),s.addEventListener("end",k),s.addEventListener("inputsourceschange",K),M.xrCompatible!==!0&&await t.makeXRCompatible(),v=e.getPixelRatio(),e.getSize(_),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let _e=null,oe=null,de=null;M.depth&&(de=M.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,_e=M.stencil?Ps:Ts,oe=M.stencil?Fr:Gi);let Ne={colorFormat:t.RGBA8,depthFormat:de,scaleFactor:r};d=this.getBinding(),u=d.createProjectionLayer(Ne),s.updateRenderState({layers:[u]}),e.setPixelRatio(1),e.setSize(u.textureWidth,u.textureHeight,!1),y=new _i(u.textureWidth,u.textureHeight,{format:Xi,type:si,depthTexture:new Rs(u.textureWidth,u.textureHeight,oe,void 0,void 0,void 0,void 0,void 0,void 0,_e),stencilBuffer:M.stencil,colorSpace:e.outputColorSpace,samples:M.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let _e={antialias:M.antialias,alpha:!0,depth:M.depth,stencil:M.stencil,framebufferScaleFactor:r};m=new XRWebGLLayer(s,t,_e),s.updateRenderState({baseLayer:m}),e.setPixelRatio(1),e.setSize(m.framebufferWidth,m.framebufferHeight,!1),y=new _i(m.framebufferWidth,m.framebufferHeight,{format:Xi,type:si,colorSpace:e.outputColorSpace,stencilBuffer:M.stencil,resolveDepthBuffer:m.ignoreDepthValues===!1,resolveStencilBuffer:m.ignoreDepthValues===!1,storeMultisampledDepthBuffer:m.ignoreDepthValues===!1,storeMultisampledStencilBuffer:m.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ce.setContext(s),ce.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return f.getDepthTexture()};function K(ee){for(let me=0;me<ee.removed.length;me++){let _e=ee.removed[me],oe=b.indexOf(_e);oe>=0&&(b[oe]=null,A[oe].disconnect(_e))}for(let me=0;me<ee.added.length;me++){let _e=ee.added[me],oe=b.indexOf(_e);if(oe===-1){for(let Ne=0;Ne<A.length;Ne++)if(Ne>=b.length){b.push(_e),oe=Ne;break}else if(b[Ne]===null){b[Ne]=_e,oe=Ne;break}if(oe===-1)break}let de=A[oe];de&&de.connect(_e)}}function Y(ee,me){me===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(me.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let me=ee.near,_e=ee.far;f.texture!==null&&(f.depthNear>0&&(me=f.depthNear),f.depthFar>0&&(_e=f.depthFar)),F.near=E.near=C.near=me,F.far=E.far=C.far=_e,(I!==F.near||O!==F.far)&&(s.updateRenderState({depthNear:F.near,depthFar:F.far}),I=F.near,O=F.far),F.layers.mask=ee.layers.mask|6,C.layers.mask=F.layers.mask&-5,E.layers.mask=F.layers.mask&-3;let oe=ee.parent,de=F.cameras;Y(F,oe);for(let Ne=0;Ne<de.length;Ne++)Y(de[Ne],oe);F.projectionMatrix.copy(C.projectionMatrix),F.projectionMatrixInverse.copy(C.projectionMatrixInverse),D===null&&ee.isPerspectiveCamera&&(D={camera:ee,fov:ee.fov,zoom:ee.zoom}),Z(ee,F,oe)};function Z(ee,me,_e){_e===null?ee.matrix.copy(me.matrixWorld):(ee.matrix.copy(_e.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(me.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(me.projectionMatrix),ee.projectionMatrixInverse.copy(me.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=No*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return F},this.getFoveation=function(){if(!(u===null&&m===null))return l},this.setFoveation=function(ee){l=ee,u!==null&&(u.fixedFoveation=ee),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=ee)},this.hasDepthSensing=function(){return f.texture!==null},this.getDepthSensingMesh=function(){return f.getMesh(F)},this.getCameraTexture=function(ee){return p[ee]};let te=null;function le(ee,me){if(h=me.getViewerPose(c||o),g=me,h!==null){let _e=h.views;m!==null&&(e.setRenderTargetFramebuffer(y,m.framebuffer),e.setRenderTarget(y));let oe=!1;_e.length!==F.cameras.length&&(F.cameras.length=0,oe=!0);for(let Be=0;Be<_e.length;Be++){let st=_e[Be],at=null;if(m!==null)at=m.getViewport(st);else{let St=d.getViewSubImage(u,st);at=St.viewport,Be===0&&(e.setRenderTargetTextures(y,St.colorTexture,St.depthStencilTexture),e.setRenderTarget(y))}let Xe=L[Be];Xe===void 0&&(Xe=new jn,Xe.layers.enable(Be),Xe.viewport=new Dt,L[Be]=Xe),Xe.matrix.fromArray(st.transform.matrix),Xe.matrix.decompose(Xe.position,Xe.quaternion,Xe.scale),Xe.projectionMatrix.fromArray(st.projectionMatrix),Xe.projectionMatrixInverse.copy(Xe.projectionMatrix).invert(),Xe.viewport.set(at.x,at.y,at.width,at.height),Be===0&&(F.matrix.copy(Xe.matrix),F.matrix.decompose(F.position,F.quaternion,F.scale)),oe===!0&&F.cameras.push(Xe)}let de=s.enabledFeatures;if(de&&de.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){d=i.getBinding();let Be=d.getDepthInformation(_e[0]);Be&&Be.isValid&&Be.texture&&f.init(Be,s.renderState)}if(de&&de.includes("camera-access")&&x){e.state.unbindTexture(),d=i.getBinding();for(let Be=0;Be<_e.length;Be++){let st=_e[Be].camera;if(st){let at=p[st];at||(at=new Oa,p[st]=at);let Xe=d.getCameraImage(st);at.sourceTexture=Xe}}}}for(let _e=0;_e<A.length;_e++){let oe=b[_e],de=A[_e];oe!==null&&de!==void 0&&de.update(oe,me,c||o)}te&&te(ee,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),g=null}let ce=new u_;ce.setAnimationLoop(le),this.setAnimationLoop=function(ee){te=ee},this.dispose=function(){}}},RE=new Ot,S_=new rt;S_.set(-1,0,0,0,1,0,0,0,1);function CE(n,e){function t(f,p){f.matrixAutoUpdate===!0&&f.updateMatrix(),p.value.copy(f.matrix)}function i(f,p){p.color.getRGB(f.fogColor.value,_f(n)),p.isFog?(f.fogNear.value=p.near,f.fogFar.value=p.far):p.isFogExp2&&(f.fogDensity.value=p.density)}function s(f,p,M,P,y){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(f,p):p.isMeshLambertMaterial?(r(f,p),p.envMap&&(f.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(f,p),d(f,p)):p.isMeshPhongMaterial?(r(f,p),h(f,p),p.envMap&&(f.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(f,p),u(f,p),p.isMeshPhysicalMaterial&&m(f,p,y)):p.isMeshMatcapMaterial?(r(f,p),g(f,p)):p.isMeshDepthMaterial?r(f,p):p.isMeshDistanceMaterial?(r(f,p),x(f,p)):p.isMeshNormalMaterial?r(f,p):p.isLineBasicMaterial?(o(f,p),p.isLineDashedMaterial&&a(f,p)):p.isPointsMaterial?l(f,p,M,P):p.isSpriteMaterial?c(f,p):p.isShadowMaterial?(f.color.value.copy(p.color),f.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(f,p){f.opacity.value=p.opacity,p.color&&f.diffuse.value.copy(p.color),p.emissive&&f.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(f.map.value=p.map,t(p.map,f.mapTransform)),p.alphaMap&&(f.alphaMap.value=p.alphaMap,t(p.alphaMap,f.alphaMapTransform)),p.bumpMap&&(f.bumpMap.value=p.bumpMap,t(p.bumpMap,f.bumpMapTransform),f.bumpScale.value=p.bumpScale,p.side===ti&&(f.bumpScale.value*=-1)),p.normalMap&&(f.normalMap.value=p.normalMap,t(p.normalMap,f.normalMapTransform),f.normalScale.value.copy(p.normalScale),p.side===ti&&f.normalScale.value.negate()),p.displacementMap&&(f.displacementMap.value=p.displacementMap,t(p.displacementMap,f.displacementMapTransform),f.displacementScale.value=p.displacementScale,f.displacementBias.value=p.displacementBias),p.emissiveMap&&(f.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,f.emissiveMapTransform)),p.specularMap&&(f.specularMap.value=p.specularMap,t(p.specularMap,f.specularMapTransform)),p.alphaTest>0&&(f.alphaTest.value=p.alphaTest);let M=e.get(p),P=M.envMap,y=M.envMapRotation;P&&(f.envMap.value=P,f.envMapRotation.value.setFromMatrix4(RE.makeRotationFromEuler(y)).transpose(),P.isCubeTexture&&P.isRenderTargetTexture===!1&&f.envMapRotation.value.premultiply(S_),f.reflectivity.value=p.reflectivity,f.ior.value=p.ior,f.refractionRatio.value=p.refractionRatio),p.lightMap&&(f.lightMap.value=p.lightMap,f.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,f.lightMapTransform)),p.aoMap&&(f.aoMap.value=p.aoMap,f.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,f.aoMapTransform))}function o(f,p){f.diffuse.value.copy(p.color),f.opacity.value=p.opacity,p.map&&(f.map.value=p.map,t(p.map,f.mapTransform))}function a(f,p){f.dashSize.value=p.dashSize,f.totalSize.value=p.dashSize+p.gapSize,f.scale.value=p.scale}function l(f,p,M,P){f.diffuse.value.copy(p.color),f.opacity.value=p.opacity,f.size.value=p.size*M,f.scale.value=P*.5,p.map&&(f.map.value=p.map,t(p.map,f.uvTransform)),p.alphaMap&&(f.alphaMap.value=p.alphaMap,t(p.alphaMap,f.alphaMapTransform)),p.alphaTest>0&&(f.alphaTest.value=p.alphaTest)}function c(f,p){f.diffuse.value.copy(p.color),f.opacity.value=p.opacity,f.rotation.value=p.rotation,p.map&&(f.map.value=p.map,t(p.map,f.mapTransform)),p.alphaMap&&(f.alphaMap.value=p.alphaMap,t(p.alphaMap,f.alphaMapTransform)),p.alphaTest>0&&(f.alphaTest.value=p.alphaTest)}function h(f,p){f.specular.value.copy(p.specular),f.shininess.value=Math.max(p.shininess,1e-4)}function d(f,p){p.gradientMap&&(f.gradientMap.value=p.gradientMap)}function u(f,p){f.metalness.value=p.metalness,p.metalnessMap&&(f.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,f.metalnessMapTransform)),f.roughness.value=p.roughness,p.roughnessMap&&(f.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,f.roughnessMapTransform)),p.envMap&&(f.envMapIntensity.value=p.envMapIntensity)}function m(f,p,M){f.ior.value=p.ior,p.diffuseRoughness>0&&(f.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(f.diffuseRoughnessMap.value=p.diffuseRoughnessMap,t(p.diffuseRoughnessMap,f.diffuseRoughnessMapTransform))),p.sheen>0&&(f.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),f.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(f.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,f.sheenColorMapTransform)),p.sheenRoughnessMap&&(f.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,f.sheenRoughnessMapTransform))),p.clearcoat>0&&(f.clearcoat.value=p.clearcoat,f.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(f.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,f.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(f.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,f.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(f.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,f.clearcoatNormalMapTransform),f.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===ti&&f.clearcoatNormalScale.value.negate())),p.dispersion>0&&(f.dispersion.value=p.dispersion),p.retroreflectivity>0&&(f.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(f.iridescence.value=p.iridescence,f.iridescenceIOR.value=p.iridescenceIOR,f.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,f.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(f.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,f.iridescenceMapTransform)),p.iridescenceThicknessMap&&(f.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,f.iridescenceThicknessMapTransform))),p.transmission>0&&(f.transmission.value=p.transmission,f.transmissionSamplerMap.value=M.texture,f.transmissionSamplerSize.value.set(M.width,M.height),p.transmissionMap&&(f.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,f.transmissionMapTransform)),f.thickness.value=p.thickness,p.thicknessMap&&(f.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,f.thicknessMapTransform)),f.attenuationDistance.value=p.attenuationDistance,f.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(f.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(f.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,f.anisotropyMapTransform))),f.specularIntensity.value=p.specularIntensity,f.specularColor.value.copy(p.specularColor),p.specularColorMap&&(f.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,f.specularColorMapTransform)),p.specularIntensityMap&&(f.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,f.specularIntensityMapTransform))}function g(f,p){p.matcap&&(f.matcap.value=p.matcap)}function x(f,p){let M=e.get(p).light;f.referencePosition.value.setFromMatrixPosition(M.matrixWorld),f.nearDistance.value=M.shadow.camera.near,f.farDistance.value=M.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function PE(n,e,t,i){let s={},r={};function o(M,P){let y=P.program;i.uniformBlockBinding(M,y,s[M.id])}function a(M,P){let y=s[M.id];y===void 0&&(g(M),y=l(M),s[M.id]=y,M.addEventListener("dispose",f));let A=P.program;i.updateUBOMapping(M,A);let b=e.render.frame;r[M.id]!==b&&(c(M),r[M.id]=b)}function l(M){let P=n.createBuffer(),y=M.__size,A=M.usage;return n.bindBuffer(n.UNIFORM_BUFFER,P),n.bufferData(n.UNIFORM_BUFFER,y,A),n.bindBuffer(n.UNIFORM_BUFFER,null),P}function c(M){let P=s[M.id],y=M.uniforms,A=M.__cache;n.bindBuffer(n.UNIFORM_BUFFER,P);for(let b=0,_=y.length;b<_;b++){let v=y[b];if(Array.isArray(v))for(let D=0,C=v.length;D<C;D++)h(v[D],b,D,A);else h(v,b,0,A)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(M,P,y,A){if(u(M,P,y,A)===!0){let b=M.__offset,_=M.value;if(Array.isArray(_)){let v=0;for(let D=0;D<_.length;D++){let C=_[D],E=x(C,!0);d(C,M.__data,v),v+=E.storage/Float32Array.BYTES_PER_ELEMENT}}else d(_,M.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,b,M.__data)}}function d(M,P,y){typeof M=="number"||typeof M=="boolean"?P[y]=M:M.isMatrix3?(P[y]=M.elements[0],P[y+1]=M.elements[1],P[y+2]=M.elements[2],P[y+3]=0,P[y+4]=M.elements[3],P[y+5]=M.elements[4],P[y+6]=M.elements[5],P[y+7]=0,P[y+8]=M.elements[6],P[y+9]=M.elements[7],P[y+10]=M.elements[8],P[y+11]=0):ArrayBuffer.isView(M)?P.set(M.subarray(0,P.length-y),y):M.toArray(P,y)}function u(M,P,y,A){let b=M.value,_=P+"_"+y;if(Array.isArray(b)){A[_]===void 0&&(A[_]=[]);let v=A[_],D=!1;for(let C=0;C<b.length;C++)m(b[C],v,C)===!0&&(D=!0);return D}return m(b,A,_)}function m(M,P,y){if(P[y]===void 0)return typeof M=="number"||typeof M=="boolean"?P[y]=M:ArrayBuffer.isView(M)?P[y]=M.slice():P[y]=M.clone(),!0;{let A=P[y];if(typeof M=="number"||typeof M=="boolean"){if(A!==M)return P[y]=M,!0}else{if(ArrayBuffer.isView(M))return!0;if(A.equals(M)===!1)return A.copy(M),!0}}return!1}function g(M){let P=M.uniforms,y=0,A=16;for(let _=0,v=P.length;_<v;_++){let D=Array.isArray(P[_])?P[_]:[P[_]];for(let C=0,E=D.length;C<E;C++){let L=D[C],F=Array.isArray(L.value)?L.value:[L.value],I=Array.isArray(P[_])||Array.isArray(L.value),O=y;for(let k=0,K=F.length;k<K;k++){let Y=F[k],Z=x(Y,I),te=y%A,le=te%Z.boundary,ce=te+le;y+=le,ce!==0&&A-ce<Z.storage&&(y+=A-ce),k===0&&(O=y),y+=Z.storage}let V=L.type==="int"?Int32Array:L.type==="uint"?Uint32Array:Float32Array;L.__data=new V((y-O)/Float32Array.BYTES_PER_ELEMENT),L.__offset=O}}let b=y%A;return b>0&&(y+=A-b),M.__size=y,M.__cache={},this}function x(M,P){let y={boundary:0,storage:0};return typeof M=="number"||typeof M=="boolean"?(y.boundary=4,y.storage=4):M.isVector2?(y.boundary=8,y.storage=8):M.isVector3||M.isColor?(y.boundary=16,y.storage=12):M.isVector4?(y.boundary=16,y.storage=16):M.isMatrix3?(y.boundary=16,y.storage=48):M.isMatrix4?(y.boundary=16,y.storage=64):M.isTexture?je("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(M)?(y.boundary=16,y.storage=M.byteLength):je("WebGLRenderer: Unsupported uniform value type.",M),P===!0&&(y.boundary=16,y.storage=Math.ceil(y.storage/16)*16),y}function f(M){let P=M.target;P.removeEventListener("dispose",f),n.deleteBuffer(s[P.id]),delete s[P.id],delete r[P.id]}function p(){for(let M in s)n.deleteBuffer(s[M]);s={},r={}}return{bind:o,update:a,dispose:p}}var IE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ls=null;function LE(){return ls===null&&(ls=new Pc(IE,16,16,rr,Wi),ls.name="DFG_LUT",ls.minFilter=Kn,ls.magFilter=Kn,ls.wrapS=ss,ls.wrapT=ss,ls.generateMipmaps=!1,ls.needsUpdate=!0),ls}var Gh=class{constructor(e={}){let{canvas:t=O0(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:m=si}=e;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let x=m,f=new Set([oh,rh,sh]),p=new Set([si,Gi,Wo,Fr,nh,ih]),M=new Uint32Array(4),P=new Int32Array(4),y={textures:[],min:[],max:[],resolution:[]},A=null,b=null,_=[],v=[],D=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=as,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let C=this,E=!1,L=null,F=null,I=null,O=null;this._outputColorSpace=Zn;let V=0,k=0,K=null,Y=-1,Z=null,te=new Dt,le=new Dt,ce=null,ee=new ht(0),me=0,_e=t.width,oe=t.height,de=1,Ne=null,$e=null,Be=new Dt(0,0,_e,oe),st=new Dt(0,0,_e,oe),at=!1,Xe=new js,St=new Ic,Ct=!1,Kt=!1,Et=new Ot,wn=new X,Mt=new Dt,_n={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Qt=!1;function an(){return K===null?de:1}let H=i;function Pe(R,W){return t.getContext(R,W)}let Je,lt,Ee,kt,We,Ze,N,w,$,pe,he,ve,Se,ie,re,xe,G,ae,se,Te,ye,we,qe;try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Ve,!1),t.addEventListener("webglcontextrestored",tt,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),H===null){let W="webgl2";if(H=Pe(W,R),H===null)throw Pe(W)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}et()}catch(R){throw t.removeEventListener("webglcontextlost",Ve,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),it("WebGLRenderer: "+R.message),R}function et(){Je=new H1(H),Je.init(),ye=new EE(H,Je),lt=new L1(H,Je,e,ye),Ee=new bE(H,Je),lt.reversedDepthBuffer&&u&&Ee.buffers.depth.setReversed(!0),F=H.createFramebuffer(),I=H.createFramebuffer(),O=H.createFramebuffer(),kt=new q1(H),We=new cE,Ze=new wE(H,Je,Ee,We,lt,ye,kt),N=new G1(C),w=new $S(H),we=new P1(H,w),$=new W1(H,w,kt,we),pe=new $1(H,$,w,we,kt),ae=new Y1(H,lt,Ze),re=new D1(We),he=new lE(C,N,Je,lt,we,re),ve=new CE(C,We),Se=new uE,ie=new _E(Je),G=new C1(C,N,Ee,pe,g,l),xe=new ME(C,pe,lt),qe=new PE(H,kt,lt,Ee),se=new I1(H,Je,kt),Te=new X1(H,Je,kt),kt.programs=he.programs,C.capabilities=lt,C.extensions=Je,C.properties=We,C.renderLists=Se,C.shadowMap=xe,C.state=Ee,C.info=kt}x!==si&&(D=new j1(x,t.width,t.height,a,s,r));let fe=new Uf(C,H);this.xr=fe,this.getContext=function(){return H},this.getContextAttributes=function(){return H.getContextAttributes()},this.forceContextLoss=function(){let R=Je.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=Je.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return de},this.setPixelRatio=function(R){R!==void 0&&(de=R,this.setSize(_e,oe,!1))},this.getSize=function(R){return R.set(_e,oe)},this.setSize=function(R,W,ne=!0){if(fe.isPresenting){je("WebGLRenderer: Can't change size while VR device is presenting.");return}_e=R,oe=W,t.width=Math.floor(R*de),t.height=Math.floor(W*de),ne===!0&&(t.style.width=R+"px",t.style.height=W+"px"),D!==null&&D.setSize(t.width,t.height),this.setViewport(0,0,R,W)},this.getDrawingBufferSize=function(R){return R.set(_e*de,oe*de).floor()},this.setDrawingBufferSize=function(R,W,ne){_e=R,oe=W,de=ne,t.width=Math.floor(R*ne),t.height=Math.floor(W*ne),this.setViewport(0,0,R,W)},this.setEffects=function(R){if(x===si){it("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let W=0;W<R.length;W++)if(R[W].isOutputPass===!0){je("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}D.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(te)},this.getViewport=function(R){return R.copy(Be)},this.setViewport=function(R,W,ne,j){R.isVector4?Be.set(R.x,R.y,R.z,R.w):Be.set(R,W,ne,j),Ee.viewport(te.copy(Be).multiplyScalar(an()).round())},this.getScissor=function(R){return R.copy(st)},this.setScissor=function(R,W,ne,j){R.isVector4?st.set(R.x,R.y,R.z,R.w):st.set(R,W,ne,j),Ee.scissor(le.copy(st).multiplyScalar(an()).round())},this.getScissorTest=function(){return at},this.setScissorTest=function(R){Ee.setScissorTest(at=R)},this.setOpaqueSort=function(R){Ne=R},this.setTransparentSort=function(R){$e=R},this.getClearColor=function(R){return R.copy(G.getClearColor())},this.setClearColor=function(){G.setClearColor(...arguments)},this.getClearAlpha=function(){return G.getClearAlpha()},this.setClearAlpha=function(){G.setClearAlpha(...arguments)},this.clear=function(R=!0,W=!0,ne=!0){let j=0;if(R){let J=!1;if(K!==null){let Ae=K.texture.format;J=f.has(Ae)}if(J){let Ae=K.texture.type,Le=p.has(Ae),Re=G.getClearColor(),De=G.getClearAlpha(),He=Re.r,nt=Re.g,mt=Re.b;Le?(M[0]=He,M[1]=nt,M[2]=mt,M[3]=De,H.clearBufferuiv(H.COLOR,0,M)):(P[0]=He,P[1]=nt,P[2]=mt,P[3]=De,H.clearBufferiv(H.COLOR,0,P))}else j|=H.COLOR_BUFFER_BIT}W&&(j|=H.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),ne&&(j|=H.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),j!==0&&H.clear(j)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),L=R},this.dispose=function(){t.removeEventListener("webglcontextlost",Ve,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),G.dispose(),Se.dispose(),ie.dispose(),Ze.dispose(),We.dispose(),N.dispose(),pe.dispose(),$.dispose(),we.dispose(),qe.dispose(),he.dispose(),fe.dispose(),fe.removeEventListener("sessionstart",pl),fe.removeEventListener("sessionend",qi),fs.stop()};function Ve(R){R.preventDefault(),Aa("WebGLRenderer: Context Lost."),E=!0}function tt(){Aa("WebGLRenderer: Context Restored."),E=!1;let R=kt.autoReset,W=xe.enabled,ne=xe.autoUpdate,j=xe.needsUpdate,J=xe.type;et(),kt.autoReset=R,xe.enabled=W,xe.autoUpdate=ne,xe.needsUpdate=j,xe.type=J}function Ce(R){it("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function ut(R){let W=R.target;W.removeEventListener("dispose",ut),Wt(W)}function Wt(R){Gn(R),We.remove(R)}function Gn(R){let W=We.get(R).programs;W!==void 0&&(W.forEach(function(ne){he.releaseProgram(ne)}),R.isShaderMaterial&&he.releaseShaderCache(R))}this.renderBufferDirect=function(R,W,ne,j,J,Ae){W===null&&(W=_n);let Le=J.isMesh&&J.matrixWorld.determinantAffine()<0,Re=Ko(R,W,ne,j,J);Ee.setMaterial(j,Le);let De=ne.index,He=1;if(j.wireframe===!0){if(De=$.getWireframeAttribute(ne),De===void 0)return;He=2}let nt=ne.drawRange,mt=ne.attributes.position,Ge=nt.start*He,gt=(nt.start+nt.count)*He;Ae!==null&&(Ge=Math.max(Ge,Ae.start*He),gt=Math.min(gt,(Ae.start+Ae.count)*He)),De!==null?(Ge=Math.max(Ge,0),gt=Math.min(gt,De.count)):mt!=null&&(Ge=Math.max(Ge,0),gt=Math.min(gt,mt.count));let Jt=gt-Ge;if(Jt<0||Jt===1/0)return;we.setup(J,j,Re,ne,De);let Nt,Ut=se;if(De!==null&&(Nt=w.get(De),Ut=Te,Ut.setIndex(Nt)),J.isMesh)j.wireframe===!0?(Ee.setLineWidth(j.wireframeLinewidth*an()),Ut.setMode(H.LINES)):Ut.setMode(H.TRIANGLES);else if(J.isLine){let xn=j.linewidth;xn===void 0&&(xn=1),Ee.setLineWidth(xn*an()),J.isLineSegments?Ut.setMode(H.LINES):J.isLineLoop?Ut.setMode(H.LINE_LOOP):Ut.setMode(H.LINE_STRIP)}else J.isPoints?Ut.setMode(H.POINTS):J.isSprite&&Ut.setMode(H.TRIANGLES);if(J.isBatchedMesh)if(Je.get("WEBGL_multi_draw"))Ut.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let xn=J._multiDrawStarts,ke=J._multiDrawCounts,ln=J._multiDrawCount,xt=De?w.get(De).bytesPerElement:1,ms=We.get(j).currentProgram.getUniforms();for(let cn=0;cn<ln;cn++)ms.setValue(H,"_gl_DrawID",cn),Ut.render(xn[cn]/xt,ke[cn])}else if(J.isInstancedMesh)Ut.renderInstances(Ge,Jt,J.count);else if(ne.isInstancedBufferGeometry){let xn=ne._maxInstanceCount!==void 0?ne._maxInstanceCount:1/0,ke=Math.min(ne.instanceCount,xn);Ut.renderInstances(Ge,Jt,ke)}else Ut.render(Ge,Jt)};function Zo(R,W,ne,j){L!==null&&R.isNodeMaterial&&L.setObject(j,R),Ct===!0&&re.setState(R,ne,!1),R.transparent===!0&&R.side===os&&R.forceSinglePass===!1?(R.side=ti,R.needsUpdate=!0,Yi(R,W,j),R.side=sr,R.needsUpdate=!0,Yi(R,W,j),R.side=os):Yi(R,W,j)}this.compile=function(R,W,ne=null){ne===null&&(ne=R),L!==null&&L.renderStart(R,W,ne),b=ie.get(ne),b.init(W),v.push(b),ne.traverseVisible(function(J){J.isLight&&J.layers.test(W.layers)&&(b.pushLight(J),J.castShadow&&b.pushShadow(J))}),R!==ne&&R.traverseVisible(function(J){J.isLight&&J.layers.test(W.layers)&&(b.pushLight(J),J.castShadow&&b.pushShadow(J))}),b.setupLights(),L!==null&&L.updateLights(b.state.lightsArray),Kt=this.localClippingEnabled,Ct=re.init(this.clippingPlanes,Kt),Ct===!0&&re.setGlobalState(this.clippingPlanes,W),L!==null&&xe.render(b.state.shadowsArray,ne,W);let j=new Set;return R.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let Ae=J.material;if(Ae)if(Array.isArray(Ae))for(let Le=0;Le<Ae.length;Le++){let Re=Ae[Le];Zo(Re,ne,W,J),j.add(Re)}else Zo(Ae,ne,W,J),j.add(Ae)}),b=v.pop(),L!==null&&L.renderEnd(),j},this.compileAsync=function(R,W,ne=null){let j=this.compile(R,W,ne);return new Promise(J=>{function Ae(){if(j.forEach(function(Le){let De=We.get(Le).currentProgram;(De===void 0||De.isReady())&&j.delete(Le)}),j.size===0){J(R);return}setTimeout(Ae,10)}Je.get("KHR_parallel_shader_compile")!==null?Ae():setTimeout(Ae,10)})};let Gr=null;function nu(R){Gr&&Gr(R)}function pl(){fs.stop()}function qi(){fs.start()}let fs=new u_;fs.setAnimationLoop(nu),typeof self<"u"&&fs.setContext(self),this.setAnimationLoop=function(R){Gr=R,fe.setAnimationLoop(R),R===null?fs.stop():fs.start()},fe.addEventListener("sessionstart",pl),fe.addEventListener("sessionend",qi),this.render=function(R,W){if(W!==void 0&&W.isCamera!==!0){it("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(E===!0)return;L!==null&&L.renderStart(R,W);let ne=fe.enabled===!0&&fe.isPresenting===!0,j=D!==null&&(K===null||ne)&&D.begin(C,K);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),W.parent===null&&W.matrixWorldAutoUpdate===!0&&W.updateMatrixWorld(),fe.enabled===!0&&fe.isPresenting===!0&&(D===null||D.isCompositing()===!1)&&(fe.cameraAutoUpdate===!0&&fe.updateCamera(W),W=fe.getCamera()),R.isScene===!0&&R.onBeforeRender(C,R,W,K),b=ie.get(R,v.length),b.init(W),b.state.textureUnits=Ze.getTextureUnits(),v.push(b),Et.multiplyMatrices(W.projectionMatrix,W.matrixWorldInverse),W.isArrayCamera?St.setFromArrayCamera(W):Xe.setFromProjectionMatrix(Et,Ei,W.reversedDepth),Kt=this.localClippingEnabled,Ct=re.init(this.clippingPlanes,Kt),A=Se.get(R,_.length),A.init(),_.push(A),this.info.render.frame++,fe.enabled===!0&&fe.isPresenting===!0){let Le=C.xr.getDepthSensingMesh();Le!==null&&ps(Le,W,-1/0,C.sortObjects)}ps(R,W,0,C.sortObjects),A.finish(),L!==null&&L.updateLights(b.state.lightsArray),C.sortObjects===!0&&A.sort(Ne,$e),Qt=fe.enabled===!1||fe.isPresenting===!1||fe.hasDepthSensing()===!1,Qt&&G.addToRenderList(A,R),this.info.autoReset===!0&&this.info.reset(),Ct===!0&&re.beginShadows();let J=b.state.shadowsArray;if(xe.render(J,R,W),Ct===!0&&re.endShadows(),(j&&D.hasRenderPass())===!1){let Le=A.opaque,Re=A.transmissive;if(b.setupLights(),W.isArrayCamera){let De=W.cameras;if(Re.length>0)for(let He=0,nt=De.length;He<nt;He++){let mt=De[He];Ai(Le,Re,R,mt)}Qt&&G.render(R);for(let He=0,nt=De.length;He<nt;He++){let mt=De[He];jo(A,R,mt,mt.viewport)}}else Re.length>0&&Ai(Le,Re,R,W),Qt&&G.render(R),jo(A,R,W)}K!==null&&k===0&&(Ze.updateMultisampleRenderTarget(K),Ze.updateRenderTargetMipmap(K)),j&&D.end(C),R.isScene===!0&&R.onAfterRender(C,R,W),we.resetDefaultState(),Y=-1,Z=null,v.pop(),v.length>0?(b=v[v.length-1],Ze.setTextureUnits(b.state.textureUnits),Ct===!0&&re.setGlobalState(C.clippingPlanes,b.state.camera)):b=null,_.pop(),_.length>0?A=_[_.length-1]:A=null,L!==null&&L.renderEnd()};function ps(R,W,ne,j){if(R.visible===!1)return;if(R.layers.test(W.layers)){if(R.isGroup)ne=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(W);else if(R.isLight)b.pushLight(R),R.castShadow&&b.pushShadow(R);else if(R.isSprite){let Le=W.isArrayCamera?St:Xe;if(!R.frustumCulled||R.intersectsFrustum(Le)){j&&Mt.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Et);let Re=pe.update(R),De=R.material;De.visible&&A.push(R,Re,De,ne,Mt.z,null,W)}}else if(R.isMesh||R.isLine||R.isPoints){let Le=W.isArrayCamera?St:Xe;if(!R.frustumCulled||R.intersectsFrustum(Le)){let Re=pe.update(R),De=R.material;if(j&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),Mt.copy(R.boundingSphere.center)):(Re.boundingSphere===null&&Re.computeBoundingSphere(),Mt.copy(Re.boundingSphere.center)),Mt.applyMatrix4(R.matrixWorld).applyMatrix4(Et)),Array.isArray(De)){let He=Re.groups;for(let nt=0,mt=He.length;nt<mt;nt++){let Ge=He[nt],gt=De[Ge.materialIndex];gt&&gt.visible&&A.push(R,Re,gt,ne,Mt.z,Ge,W)}}else De.visible&&A.push(R,Re,De,ne,Mt.z,null,W)}}}let Ae=R.children;for(let Le=0,Re=Ae.length;Le<Re;Le++)ps(Ae[Le],W,ne,j)}function jo(R,W,ne,j){let{opaque:J,transmissive:Ae,transparent:Le}=R;b.setupLightsView(ne),Ct===!0&&re.setGlobalState(C.clippingPlanes,ne),j&&Ee.viewport(te.copy(j)),J.length>0&&en(J,W,ne),Ae.length>0&&en(Ae,W,ne),Le.length>0&&en(Le,W,ne),Ee.buffers.depth.setTest(!0),Ee.buffers.depth.setMask(!0),Ee.buffers.color.setMask(!0),Ee.setPolygonOffset(!1)}function Ai(R,W,ne,j){if((ne.isScene===!0?ne.overrideMaterial:null)!==null)return;if(b.state.transmissionRenderTarget[j.id]===void 0){let Ge=Je.has("EXT_color_buffer_half_float")||Je.has("EXT_color_buffer_float");b.state.transmissionRenderTarget[j.id]=new _i(1,1,{generateMipmaps:!0,type:Ge?Wi:si,minFilter:Cs,samples:Math.max(4,lt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:vt.workingColorSpace})}let Ae=b.state.transmissionRenderTarget[j.id],Le=j.viewport||te;Ae.setSize(Le.z*C.transmissionResolutionScale,Le.w*C.transmissionResolutionScale);let Re=C.getRenderTarget(),De=C.getActiveCubeFace(),He=C.getActiveMipmapLevel();C.setRenderTarget(Ae),C.getClearColor(ee),me=C.getClearAlpha(),me<1&&C.setClearColor(16777215,.5),C.clear(),Qt&&G.render(ne);let nt=C.toneMapping;C.toneMapping=as;let mt=j.viewport;if(j.viewport!==void 0&&(j.viewport=void 0),b.setupLightsView(j),Ct===!0&&re.setGlobalState(C.clippingPlanes,j),en(R,ne,j),Ze.updateMultisampleRenderTarget(Ae),Ze.updateRenderTargetMipmap(Ae),Je.has("WEBGL_multisampled_render_to_texture")===!1){let Ge=!1;for(let gt=0,Jt=W.length;gt<Jt;gt++){let Nt=W[gt],{object:Ut,geometry:xn,material:ke,group:ln}=Nt;if(ke.side===os&&Ut.layers.test(j.layers)){let xt=ke.side;ke.side=ti,ke.needsUpdate=!0,rn(Ut,ne,j,xn,ke,ln),ke.side=xt,ke.needsUpdate=!0,Ge=!0}}Ge===!0&&(Ze.updateMultisampleRenderTarget(Ae),Ze.updateRenderTargetMipmap(Ae))}C.setRenderTarget(Re,De,He),C.setClearColor(ee,me),mt!==void 0&&(j.viewport=mt),C.toneMapping=nt}function en(R,W,ne){let j=W.isScene===!0?W.overrideMaterial:null;for(let J=0,Ae=R.length;J<Ae;J++){let Le=R[J],{object:Re,geometry:De,group:He}=Le,nt=Le.material;nt.allowOverride===!0&&j!==null&&(nt=j),Re.layers.test(ne.layers)&&rn(Re,W,ne,De,nt,He)}}function rn(R,W,ne,j,J,Ae){L!==null&&J.isNodeMaterial&&L.setObject(R,J),R.onBeforeRender(C,W,ne,j,J,Ae),R.modelViewMatrix.multiplyMatrices(ne.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),J.onBeforeRender(C,W,ne,j,R,Ae),J.transparent===!0&&J.side===os&&J.forceSinglePass===!1?(J.side=ti,J.needsUpdate=!0,C.renderBufferDirect(ne,W,j,J,R,Ae),J.side=sr,J.needsUpdate=!0,C.renderBufferDirect(ne,W,j,J,R,Ae),J.side=os):C.renderBufferDirect(ne,W,j,J,R,Ae),R.onAfterRender(C,W,ne,j,J,Ae)}function on(R){let W=0;for(let ne of R)ne.texture!==null&&W++;return W}function Yi(R,W,ne){W.isScene!==!0&&(W=_n);let j=We.get(R),J=b.state.lights,Ae=b.state.shadowsArray,Le=J.state.version,Re=he.getParameters(R,J.state,Ae,W,ne,b.state.lightProbeGridArray),De=he.getProgramCacheKey(Re),He=j.programs;j.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?W.environment:null,j.fog=W.fog;let nt=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;j.envMap=N.get(R.envMap||j.environment,nt),j.envMapRotation=j.environment!==null&&R.envMap===null?W.environmentRotation:R.envMapRotation,He===void 0&&(R.addEventListener("dispose",ut),He=new Map,j.programs=He,j.programVariants=new Map);let mt=He.get(De);if(mt!==void 0){if(j.currentProgram===mt&&j.lightsStateVersion===Le)return Jo(R,Re),mt}else Re.uniforms=he.getUniforms(R),L!==null&&R.isNodeMaterial&&L.build(R,ne,Re),R.onBeforeCompile(Re,C),mt=he.acquireProgram(Re,De),He.set(De,mt),j.uniforms=Re.uniforms;let Ge=j.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Ge.clippingPlanes=re.uniform),Jo(R,Re),j.needsLights=Ns(R),j.lightsStateVersion=Le,j.needsLights&&(Ge.ambientLightColor.value=J.state.ambient,Ge.lightProbe.value=J.state.probe,Ge.sunLights.value=J.state.sun,Ge.sunLightShadows.value=J.state.sunShadow,Ge.directionalLights.value=J.state.directional,Ge.directionalLightShadows.value=J.state.directionalShadow,Ge.spotLights.value=J.state.spot,Ge.spotLightShadows.value=J.state.spotShadow,Ge.rectAreaLights.value=J.state.rectArea,Ge.ltc_1.value=J.state.rectAreaLTC1,Ge.ltc_2.value=J.state.rectAreaLTC2,Ge.pointLights.value=J.state.point,Ge.pointLightShadows.value=J.state.pointShadow,Ge.hemisphereLights.value=J.state.hemi,Ge.sunShadowMatrix.value=J.state.sunShadowMatrix,Ge.sunShadowCascade.value=J.state.sunShadowCascade,Ge.directionalShadowMatrix.value=J.state.directionalShadowMatrix,Ge.spotLightMatrix.value=J.state.spotLightMatrix,Ge.spotLightMap.value=J.state.spotLightMap,Ge.pointShadowMatrix.value=J.state.pointShadowMatrix),j.numLightProbeGrids=on(b.state.lightProbeGridArray),j.currentProgram=mt,j.uniformsList=null,mt}function oi(R,W,ne,j,J){let Ae=We.get(R),Le=Ae.currentProgram.id+","+j+","+J,Re=Ae.programVariants.get(Le);return Re===void 0?(Re=Yi(R,W,ne),Ae.programVariants.set(Le,Re)):(Ae.currentProgram=Re,Ae.uniformsList=null,Ae.outputColorSpace=j,Ae.toneMapping=J),Re}function Ds(R){if(R.uniformsList===null){let W=R.currentProgram.getUniforms();R.uniformsList=Xo.seqWithValue(W.seq,R.uniforms)}return R.uniformsList}function Jo(R,W){let ne=We.get(R);ne.outputColorSpace=W.outputColorSpace,ne.batching=W.batching,ne.batchingColor=W.batchingColor,ne.instancing=W.instancing,ne.instancingColor=W.instancingColor,ne.instancingMorph=W.instancingMorph,ne.skinning=W.skinning,ne.morphTargets=W.morphTargets,ne.morphNormals=W.morphNormals,ne.morphColors=W.morphColors,ne.morphTargetsCount=W.morphTargetsCount,ne.numClippingPlanes=W.numClippingPlanes,ne.numIntersection=W.numClipIntersection,ne.vertexAlphas=W.vertexAlphas,ne.vertexTangents=W.vertexTangents,ne.toneMapping=W.toneMapping}function Ko(R,W,ne,j,J){W.isScene!==!0&&(W=_n),Ze.resetTextureUnits();let Ae=W.fog,Le=j.isMeshStandardMaterial||j.isMeshLambertMaterial||j.isMeshPhongMaterial?W.environment:null,Re=K===null?C.outputColorSpace:K.isXRRenderTarget===!0?K.texture.colorSpace:vt.workingColorSpace,De=j.isMeshStandardMaterial||j.isMeshLambertMaterial&&!j.envMap||j.isMeshPhongMaterial&&!j.envMap,He=N.get(j.envMap||Le,De),nt=j.vertexColors===!0&&!!ne.attributes.color&&ne.attributes.color.itemSize===4,mt=!!ne.attributes.tangent&&(!!j.normalMap||j.anisotropy>0),Ge=!!ne.morphAttributes.position,gt=!!ne.morphAttributes.normal,Jt=!!ne.morphAttributes.color,Nt=as;j.toneMapped&&(K===null||K.isXRRenderTarget===!0)&&(Nt=C.toneMapping);let Ut=ne.morphAttributes.position||ne.morphAttributes.normal||ne.morphAttributes.color,xn=Ut!==void 0?Ut.length:0,ke=We.get(j),ln=b.state.lights;if(Ct===!0&&(Kt===!0||R!==Z)){let Ft=R===Z&&j.id===Y;re.setState(j,R,Ft)}let xt=!1,ms=!1;j.version===ke.__version?ke.needsLights&&ke.lightsStateVersion!==ln.state.version||J.isBatchedMesh&&ke.batching===!1||!J.isBatchedMesh&&ke.batching===!0||J.isBatchedMesh&&ke.batchingColor===!0&&J._colorsTexture===null||J.isBatchedMesh&&ke.batchingColor===!1&&J._colorsTexture!==null||J.isInstancedMesh&&ke.instancing===!1||!J.isInstancedMesh&&ke.instancing===!0||J.isSkinnedMesh&&ke.skinning===!1||!J.isSkinnedMesh&&ke.skinning===!0||J.isInstancedMesh&&ke.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&ke.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&ke.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&ke.instancingMorph===!1&&J.morphTexture!==null||ke.envMap!==He||j.fog===!0&&ke.fog!==Ae||ke.numClippingPlanes!==void 0&&(ke.numClippingPlanes!==re.numPlanes||ke.numIntersection!==re.numIntersection)||ke.vertexAlphas!==nt||ke.vertexTangents!==mt||ke.morphTargets!==Ge||ke.morphNormals!==gt||ke.morphColors!==Jt||ke.morphTargetsCount!==xn||ke.numLightProbeGrids!==on(b.state.lightProbeGridArray)?xt=!0:(ke.outputColorSpace!==Re||ke.toneMapping!==Nt)&&(ms=!0):(xt=!0,ke.__version=j.version);let cn=ke.currentProgram;(xt===!0||ms===!0)&&(cn=ms===!0?oi(j,W,J,Re,Nt):Yi(j,W,J),L&&j.isNodeMaterial&&L.onUpdateProgram(j,cn,ke));let Xr=!1,$i=!1,gs=!1,dt=cn.getUniforms(),tn=ke.uniforms;if(Ee.useProgram(cn.program)&&(Xr=!0,$i=!0,gs=!0),j.id!==Y&&(Y=j.id,$i=!0),Xr||Z!==R){Ee.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),dt.setValue(H,"projectionMatrix",R.projectionMatrix),dt.setValue(H,"viewMatrix",R.matrixWorldInverse);let hn=dt.map.cameraPosition;hn!==void 0&&hn.setValue(H,wn.setFromMatrixPosition(R.matrixWorld)),lt.logarithmicDepthBuffer&&dt.setValue(H,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(j.isMeshPhongMaterial||j.isMeshToonMaterial||j.isMeshLambertMaterial||j.isMeshBasicMaterial||j.isMeshStandardMaterial||j.isShaderMaterial)&&dt.setValue(H,"isOrthographic",R.isOrthographicCamera===!0),Z!==R&&(Z=R,$i=!0,gs=!0)}if(ke.needsLights&&(ln.state.sunShadowMap.length>0&&dt.setValue(H,"sunShadowMap",ln.state.sunShadowMap,Ze),ln.state.directionalShadowMap.length>0&&dt.setValue(H,"directionalShadowMap",ln.state.directionalShadowMap,Ze),ln.state.spotShadowMap.length>0&&dt.setValue(H,"spotShadowMap",ln.state.spotShadowMap,Ze),ln.state.pointShadowMap.length>0&&dt.setValue(H,"pointShadowMap",ln.state.pointShadowMap,Ze)),J.isSkinnedMesh){dt.setOptional(H,J,"bindMatrix"),dt.setOptional(H,J,"bindMatrixInverse");let Ft=J.skeleton;Ft&&(Ft.boneTexture===null&&Ft.computeBoneTexture(),dt.setValue(H,"boneTexture",Ft.boneTexture,Ze))}J.isBatchedMesh&&(dt.setOptional(H,J,"batchingTexture"),dt.setValue(H,"batchingTexture",J._matricesTexture,Ze),dt.setOptional(H,J,"batchingIdTexture"),dt.setValue(H,"batchingIdTexture",J._indirectTexture,Ze),dt.setOptional(H,J,"batchingColorTexture"),J._colorsTexture!==null&&dt.setValue(H,"batchingColorTexture",J._colorsTexture,Ze));let Hn=ne.morphAttributes;if((Hn.position!==void 0||Hn.normal!==void 0||Hn.color!==void 0)&&ae.update(J,ne,cn),($i||ke.receiveShadow!==J.receiveShadow)&&(ke.receiveShadow=J.receiveShadow,dt.setValue(H,"receiveShadow",J.receiveShadow)),(j.isMeshStandardMaterial||j.isMeshLambertMaterial||j.isMeshPhongMaterial)&&j.envMap===null&&W.environment!==null&&(tn.envMapIntensity.value=W.environmentIntensity),tn.dfgLUT!==void 0&&(tn.dfgLUT.value=LE()),$i){if(dt.setValue(H,"toneMappingExposure",C.toneMappingExposure),ke.needsLights&&Hr(tn,gs),Ae&&j.fog===!0&&ve.refreshFogUniforms(tn,Ae),ve.refreshMaterialUniforms(tn,j,de,oe,b.state.transmissionRenderTarget[R.id]),ke.needsLights&&ke.numLightProbeGrids>0){let Ft=y,hn=0;for(let Fn of b.state.lightProbeGridArray)Fn.texture!==null&&(Ft.textures[hn]=Fn.texture,Ft.min[hn]=Fn.boundingBox.min,Ft.max[hn]=Fn.boundingBox.max,Ft.resolution[hn]=Fn.resolution,hn++);for(let Fn in Ft)Ft[Fn].length=hn;tn.probesSH.value=Ft.textures,tn.probesMin.value=Ft.min,tn.probesMax.value=Ft.max,tn.probesResolution.value=Ft.resolution}Xo.upload(H,Ds(ke),tn,Ze)}if(j.isShaderMaterial&&j.uniformsNeedUpdate===!0&&(Xo.upload(H,Ds(ke),tn,Ze),j.uniformsNeedUpdate=!1),j.isSpriteMaterial&&dt.setValue(H,"center",J.center),dt.setValue(H,"modelViewMatrix",J.modelViewMatrix),dt.setValue(H,"normalMatrix",J.normalMatrix),dt.setValue(H,"modelMatrix",J.matrixWorld),j.uniformsGroups!==void 0){let Ft=j.uniformsGroups;for(let hn=0,Fn=Ft.length;hn<Fn;hn++){let ml=Ft[hn];qe.update(ml,cn),qe.bind(ml,cn)}}return cn}function Hr(R,W){R.ambientLightColor.needsUpdate=W,R.lightProbe.needsUpdate=W,R.sunLights.needsUpdate=W,R.sunLightShadows.needsUpdate=W,R.directionalLights.needsUpdate=W,R.directionalLightShadows.needsUpdate=W,R.pointLights.needsUpdate=W,R.pointLightShadows.needsUpdate=W,R.spotLights.needsUpdate=W,R.spotLightShadows.needsUpdate=W,R.rectAreaLights.needsUpdate=W,R.hemisphereLights.needsUpdate=W}function Ns(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return V},this.getActiveMipmapLevel=function(){return k},this.getRenderTarget=function(){return K},this.setRenderTargetTextures=function(R,W,ne){let j=We.get(R);j.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,j.__autoAllocateDepthBuffer===!1&&(j.__useRenderToTexture=!1),We.get(R.texture).__webglTexture=W,We.get(R.depthTexture).__webglTexture=j.__autoAllocateDepthBuffer?void 0:ne,j.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,W){let ne=We.get(R);ne.__webglFramebuffer=W,ne.__useDefaultFramebuffer=W===void 0},this.setRenderTarget=function(R,W=0,ne=0){K=R,V=W,k=ne;let j=null,J=!1,Ae=!1;if(R){let Re=We.get(R);if(Re.__useDefaultFramebuffer!==void 0){Ee.bindFramebuffer(H.FRAMEBUFFER,Re.__webglFramebuffer),te.copy(R.viewport),le.copy(R.scissor),ce=R.scissorTest,Ee.viewport(te),Ee.scissor(le),Ee.setScissorTest(ce),Y=-1;return}else if(Re.__webglFramebuffer===void 0)Ze.setupRenderTarget(R);else if(Re.__hasExternalTextures)Ze.rebindTextures(R,We.get(R.texture).__webglTexture,We.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let nt=R.depthTexture;if(Re.__boundDepthTexture!==nt){if(nt!==null&&We.has(nt)&&(R.width!==nt.image.width||R.height!==nt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ze.setupDepthRenderbuffer(R)}}let De=R.texture;(De.isData3DTexture||De.isDataArrayTexture||De.isCompressedArrayTexture)&&(Ae=!0);let He=We.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(He[W])?j=He[W][ne]:j=He[W],J=!0):R.samples>0&&Ze.useMultisampledRTT(R)===!1?j=We.get(R).__webglMultisampledFramebuffer:Array.isArray(He)?j=He[ne]:j=He,te.copy(R.viewport),le.copy(R.scissor),ce=R.scissorTest}else te.copy(Be).multiplyScalar(de).floor(),le.copy(st).multiplyScalar(de).floor(),ce=at;if(ne!==0&&(j=F),Ee.bindFramebuffer(H.FRAMEBUFFER,j)&&Ee.drawBuffers(R,j),Ee.viewport(te),Ee.scissor(le),Ee.setScissorTest(ce),J){let Re=We.get(R.texture);H.framebufferTexture2D(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_CUBE_MAP_POSITIVE_X+W,Re.__webglTexture,ne)}else if(Ae){let Re=W;for(let De=0;De<R.textures.length;De++){let He=We.get(R.textures[De]);H.framebufferTextureLayer(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0+De,He.__webglTexture,ne,Re)}}else if(R!==null&&ne!==0){let Re=We.get(R.texture);H.framebufferTexture2D(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,Re.__webglTexture,ne)}Y=-1};function Wr(R){let W=We.get(R);return(W.__readFormat!==R.format||W.__readType!==R.type)&&(W.__readFormat=R.format,W.__readType=R.type,W.__formatReadable=lt.textureFormatReadable(R.format),W.__typeReadable=lt.textureTypeReadable(R.type)),W}this.readRenderTargetPixels=function(R,W,ne,j,J,Ae,Le,Re=0){if(!(R&&R.isWebGLRenderTarget)){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let De=We.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Le!==void 0&&(De=De[Le],Array.isArray(De)&&(De=De[0])),De){Ee.bindFramebuffer(H.FRAMEBUFFER,De);try{let He=R.textures[Re],nt=He.format,mt=He.type;R.textures.length>1&&H.readBuffer(H.COLOR_ATTACHMENT0+Re);let Ge=Wr(He);if(Ge.__formatReadable===!1){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ge.__typeReadable===!1){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}W>=0&&W<=R.width-j&&ne>=0&&ne<=R.height-J&&H.readPixels(W,ne,j,J,ye.convert(nt),ye.convert(mt),Ae)}finally{let He=K!==null?We.get(K).__webglFramebuffer:null;Ee.bindFramebuffer(H.FRAMEBUFFER,He)}}},this.readRenderTargetPixelsAsync=async function(R,W,ne,j,J,Ae,Le,Re=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let De=We.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Le!==void 0&&(De=De[Le],Array.isArray(De)&&(De=De[0])),De)if(W>=0&&W<=R.width-j&&ne>=0&&ne<=R.height-J){Ee.bindFramebuffer(H.FRAMEBUFFER,De);let He=R.textures[Re],nt=He.format,mt=He.type;R.textures.length>1&&H.readBuffer(H.COLOR_ATTACHMENT0+Re);let Ge=Wr(He);if(Ge.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ge.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let gt=H.createBuffer();H.bindBuffer(H.PIXEL_PACK_BUFFER,gt),H.bufferData(H.PIXEL_PACK_BUFFER,Ae.byteLength,H.STREAM_READ),H.readPixels(W,ne,j,J,ye.convert(nt),ye.convert(mt),0),H.bindBuffer(H.PIXEL_PACK_BUFFER,null);let Jt=K!==null?We.get(K).__webglFramebuffer:null;Ee.bindFramebuffer(H.FRAMEBUFFER,Jt);let Nt=H.fenceSync(H.SYNC_GPU_COMMANDS_COMPLETE,0);return H.flush(),await k0(H,Nt,4),H.bindBuffer(H.PIXEL_PACK_BUFFER,gt),H.getBufferSubData(H.PIXEL_PACK_BUFFER,0,Ae),H.bindBuffer(H.PIXEL_PACK_BUFFER,null),H.deleteBuffer(gt),H.deleteSync(Nt),Ae}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,W=null,ne=0){let j=Math.pow(2,-ne),J=Math.floor(R.image.width*j),Ae=Math.floor(R.image.height*j),Le=W!==null?W.x:0,Re=W!==null?W.y:0;Ze.setTexture2D(R,0),H.copyTexSubImage2D(H.TEXTURE_2D,ne,0,0,Le,Re,J,Ae),Ee.unbindTexture()},this.copyTextureToTexture=function(R,W,ne=null,j=null,J=0,Ae=0){let Le,Re,De,He,nt,mt,Ge,gt,Jt,Nt=R.isCompressedTexture?R.mipmaps[Ae]:R.image;if(ne!==null)Le=ne.max.x-ne.min.x,Re=ne.max.y-ne.min.y,De=ne.isBox3?ne.max.z-ne.min.z:1,He=ne.min.x,nt=ne.min.y,mt=ne.isBox3?ne.min.z:0;else{let dt=Math.pow(2,-J);Le=Math.floor(Nt.width*dt),Re=Math.floor(Nt.height*dt),R.isDataArrayTexture?De=Nt.depth:R.isData3DTexture?De=Math.floor(Nt.depth*dt):De=1,He=0,nt=0,mt=0}j!==null?(Ge=j.x,gt=j.y,Jt=j.z):(Ge=0,gt=0,Jt=0);let Ut=ye.convert(W.format),xn=ye.convert(W.type),ke;W.isData3DTexture?(Ze.setTexture3D(W,0),ke=H.TEXTURE_3D):W.isDataArrayTexture||W.isCompressedArrayTexture?(Ze.setTexture2DArray(W,0),ke=H.TEXTURE_2D_ARRAY):(Ze.setTexture2D(W,0),ke=H.TEXTURE_2D),Ee.activeTexture(H.TEXTURE0),Ee.pixelStorei(H.UNPACK_FLIP_Y_WEBGL,W.flipY),Ee.pixelStorei(H.UNPACK_PREMULTIPLY_ALPHA_WEBGL,W.premultiplyAlpha),Ee.pixelStorei(H.UNPACK_ALIGNMENT,W.unpackAlignment);let ln=Ee.getParameter(H.UNPACK_ROW_LENGTH),xt=Ee.getParameter(H.UNPACK_IMAGE_HEIGHT),ms=Ee.getParameter(H.UNPACK_SKIP_PIXELS),cn=Ee.getParameter(H.UNPACK_SKIP_ROWS),Xr=Ee.getParameter(H.UNPACK_SKIP_IMAGES);Ee.pixelStorei(H.UNPACK_ROW_LENGTH,Nt.width),Ee.pixelStorei(H.UNPACK_IMAGE_HEIGHT,Nt.height),Ee.pixelStorei(H.UNPACK_SKIP_PIXELS,He),Ee.pixelStorei(H.UNPACK_SKIP_ROWS,nt),Ee.pixelStorei(H.UNPACK_SKIP_IMAGES,mt);let $i=R.isDataArrayTexture||R.isData3DTexture,gs=W.isDataArrayTexture||W.isData3DTexture;if(R.isDepthTexture){let dt=We.get(R),tn=We.get(W),Hn=We.get(dt.__renderTarget),Ft=We.get(tn.__renderTarget);Ee.bindFramebuffer(H.READ_FRAMEBUFFER,Hn.__webglFramebuffer),Ee.bindFramebuffer(H.DRAW_FRAMEBUFFER,Ft.__webglFramebuffer);for(let hn=0;hn<De;hn++)$i&&(H.framebufferTextureLayer(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,We.get(R).__webglTexture,J,mt+hn),H.framebufferTextureLayer(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,We.get(W).__webglTexture,Ae,Jt+hn)),H.blitFramebuffer(He,nt,He+Le,nt+Re,Ge,gt,Ge+Le,gt+Re,H.DEPTH_BUFFER_BIT,H.NEAREST);Ee.bindFramebuffer(H.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(H.DRAW_FRAMEBUFFER,null)}else if(J!==0||R.isRenderTargetTexture||We.has(R)){let dt=We.get(R),tn=We.get(W);Ee.bindFramebuffer(H.READ_FRAMEBUFFER,I),Ee.bindFramebuffer(H.DRAW_FRAMEBUFFER,O);for(let Hn=0;Hn<De;Hn++)$i?H.framebufferTextureLayer(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,dt.__webglTexture,J,mt+Hn):H.framebufferTexture2D(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,dt.__webglTexture,J),gs?H.framebufferTextureLayer(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,tn.__webglTexture,Ae,Jt+Hn):H.framebufferTexture2D(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,tn.__webglTexture,Ae),J!==0?H.blitFramebuffer(He,nt,He+Le,nt+Re,Ge,gt,Ge+Le,gt+Re,H.COLOR_BUFFER_BIT,H.NEAREST):gs?H.copyTexSubImage3D(ke,Ae,Ge,gt,Jt+Hn,He,nt,Le,Re):H.copyTexSubImage2D(ke,Ae,Ge,gt,He,nt,Le,Re);Ee.bindFramebuffer(H.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(H.DRAW_FRAMEBUFFER,null)}else gs?R.isDataTexture||R.isData3DTexture?H.texSubImage3D(ke,Ae,Ge,gt,Jt,Le,Re,De,Ut,xn,Nt.data):W.isCompressedArrayTexture?H.compressedTexSubImage3D(ke,Ae,Ge,gt,Jt,Le,Re,De,Ut,Nt.data):H.texSubImage3D(ke,Ae,Ge,gt,Jt,Le,Re,De,Ut,xn,Nt):R.isDataTexture?H.texSubImage2D(H.TEXTURE_2D,Ae,Ge,gt,Le,Re,Ut,xn,Nt.data):R.isCompressedTexture?H.compressedTexSubImage2D(H.TEXTURE_2D,Ae,Ge,gt,Nt.width,Nt.height,Ut,Nt.data):H.texSubImage2D(H.TEXTURE_2D,Ae,Ge,gt,Le,Re,Ut,xn,Nt);Ee.pixelStorei(H.UNPACK_ROW_LENGTH,ln),Ee.pixelStorei(H.UNPACK_IMAGE_HEIGHT,xt),Ee.pixelStorei(H.UNPACK_SKIP_PIXELS,ms),Ee.pixelStorei(H.UNPACK_SKIP_ROWS,cn),Ee.pixelStorei(H.UNPACK_SKIP_IMAGES,Xr),Ae===0&&W.generateMipmaps===!0&&W.mipmapsAutoUpdate===!0&&H.generateMipmap(ke),Ee.unbindTexture()},this.initRenderTarget=function(R){We.get(R).__webglFramebuffer===void 0&&Ze.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?Ze.setTextureCube(R,0):R.isData3DTexture?Ze.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?Ze.setTexture2DArray(R,0):Ze.setTexture2D(R,0),Ee.unbindTexture()},this.resetState=function(){V=0,k=0,K=null,Ee.reset(),we.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ei}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=vt._getDrawingBufferColorSpace(e),t.unpackColorSpace=vt._getUnpackColorSpace()}};var M_=new xi,Xh=new X,Yo=class extends $a{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],i=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(i),this.setAttribute("position",new Ht(e,3)),this.setAttribute("uv",new Ht(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,i=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),i.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let i=new tr(t,6,1);return this.setAttribute("instanceStart",new Vi(i,3,0)),this.setAttribute("instanceEnd",new Vi(i,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let i=new tr(t,6,1);return this.setAttribute("instanceColorStart",new Vi(i,3,0)),this.setAttribute("instanceColorEnd",new Vi(i,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new za(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new xi);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),M_.setFromBufferAttribute(t),this.boundingBox.union(M_))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new zi),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let i=this.boundingSphere.center;this.boundingBox.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Xh.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Xh)),Xh.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Xh));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};Ie.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Ke},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};ni.line={uniforms:al.merge([Ie.common,Ie.fog,Ie.line]),vertexShader:`
		#include <common>
		#include <color_pars_vertex>
		#include <fog_pars_vertex>
		#include <logdepthbuf_pars_vertex>
		#include <clipping_planes_pars_vertex>

		uniform float linewidth;
		uniform vec2 resolution;

		attribute vec3 instanceStart;
		attribute vec3 instanceEnd;

		attribute vec3 instanceColorStart;
		attribute vec3 instanceColorEnd;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#ifdef USE_DASH

			uniform float dashScale;
			attribute float instanceDistanceStart;
			attribute float instanceDistanceEnd;
			varying float vLineDistance;

		#endif

		float trimSegmentAlpha( const in vec4 start, const in vec4 end ) {

			// compute the interpolation factor needed to trim the segment so it terminates
			// between the camera plane and the near plane

			// conservative estimate of the near plane
			float a = projectionMatrix[ 2 ][ 2 ]; // 3nd entry in 3th column
			float b = projectionMatrix[ 3 ][ 2 ]; // 3nd entry in 4th column

			// we need different nearEstimate formula for reversed and default depth buffer
			// a is positive with a reversed depth buffer so it can be used for controlling the code flow
			float nearEstimate = ( a > 0.0 ) ? ( - b / ( a + 1.0 ) ) : ( - 0.5 * b / a );

			return ( nearEstimate - start.z ) / ( end.z - start.z );

		}

		void main() {

			#ifdef USE_COLOR

				vColor.xyz = ( position.y < 0.5 ) ? instanceColorStart : instanceColorEnd;

			#endif

			float aspect = resolution.x / resolution.y;

			// camera space
			vec4 start = modelViewMatrix * vec4( instanceStart, 1.0 );
			vec4 end = modelViewMatrix * vec4( instanceEnd, 1.0 );

			#ifdef USE_DASH

				float lineDistanceStart = dashScale * instanceDistanceStart;
				float lineDistanceEnd = dashScale * instanceDistanceEnd;

			#endif

			#ifdef WORLD_UNITS

				worldStart = start.xyz;
				worldEnd = end.xyz;

			#else

				vUv = uv;

			#endif

			// special case for perspective projection, and segments that terminate either in, or behind, the camera plane
			// clearly the gpu firmware has a way of addressing this issue when projecting into ndc space
			// but we need to perform ndc-space calculations in the shader, so we must address this issue directly
			// perhaps there is a more elegant solution -- WestLangley

			bool perspective = ( projectionMatrix[ 2 ][ 3 ] == - 1.0 ); // 4th entry in the 3rd column

			if ( perspective ) {

				if ( start.z < 0.0 && end.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( start, end );
					end.xyz = mix( start.xyz, end.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceEnd = mix( lineDistanceStart, lineDistanceEnd, alpha );

					#endif

				} else if ( end.z < 0.0 && start.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( end, start );
					start.xyz = mix( end.xyz, start.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceStart = mix( lineDistanceEnd, lineDistanceStart, alpha );

					#endif

				}

			}

			#ifdef USE_DASH

				vLineDistance = ( position.y < 0.5 ) ? lineDistanceStart : lineDistanceEnd;
				vUv = uv;

			#endif

			// clip space
			vec4 clipStart = projectionMatrix * start;
			vec4 clipEnd = projectionMatrix * end;

			// ndc space
			vec3 ndcStart = clipStart.xyz / clipStart.w;
			vec3 ndcEnd = clipEnd.xyz / clipEnd.w;

			// direction
			vec2 dir = ndcEnd.xy - ndcStart.xy;

			// account for clip-space aspect ratio
			dir.x *= aspect;
			dir = normalize( dir );

			#ifdef WORLD_UNITS

				vec3 worldDir = normalize( end.xyz - start.xyz );
				vec3 tmpFwd = perspective ? normalize( mix( start.xyz, end.xyz, 0.5 ) ) : vec3( 0.0, 0.0, - 1.0 );
				vec3 worldUp = normalize( cross( worldDir, tmpFwd ) );
				vec3 worldFwd = cross( worldDir, worldUp );
				worldPos = position.y < 0.5 ? start: end;

				// height offset
				float hw = linewidth * 0.5;
				worldPos.xyz += position.x < 0.0 ? hw * worldUp : - hw * worldUp;

				// don't extend the line if we're rendering dashes because we
				// won't be rendering the endcaps
				#ifndef USE_DASH

					// cap extension
					worldPos.xyz += position.y < 0.5 ? - hw * worldDir : hw * worldDir;

					// add width to the box
					worldPos.xyz += worldFwd * hw;

					// endcaps
					if ( position.y > 1.0 || position.y < 0.0 ) {

						worldPos.xyz -= worldFwd * 2.0 * hw;

					}

				#endif

				// project the worldpos
				vec4 clip = projectionMatrix * worldPos;

				// shift the depth of the projected points so the line
				// segments overlap neatly
				vec3 clipPose = ( position.y < 0.5 ) ? ndcStart : ndcEnd;

				// only shift the depth of vertices in front of the camera (#35137)
				if ( clip.w > 0.0 ) clip.z = clipPose.z * clip.w;

			#else

				vec2 offset = vec2( dir.y, - dir.x );
				// undo aspect ratio adjustment
				dir.x /= aspect;
				offset.x /= aspect;

				// sign flip
				if ( position.x < 0.0 ) offset *= - 1.0;

				// endcaps
				if ( position.y < 0.0 ) {

					offset += - dir;

				} else if ( position.y > 1.0 ) {

					offset += dir;

				}

				// adjust for linewidth
				offset *= linewidth;

				// adjust for clip-space to screen-space conversion // maybe resolution should be based on viewport ...
				offset /= resolution.y;

				// select end
				vec4 clip = ( position.y < 0.5 ) ? clipStart : clipEnd;

				// back to clip space
				offset *= clip.w;

				clip.xy += offset;

			#endif

			gl_Position = clip;

			vec4 mvPosition = ( position.y < 0.5 ) ? start : end; // this is an approximation

			#include <logdepthbuf_vertex>
			#include <clipping_planes_vertex>
			#include <fog_vertex>

		}
		`,fragmentShader:`
		uniform vec3 diffuse;
		uniform float opacity;
		uniform float linewidth;

		#ifdef USE_DASH

			uniform float dashOffset;
			uniform float dashSize;
			uniform float gapSize;

		#endif

		varying float vLineDistance;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#include <common>
		#include <color_pars_fragment>
		#include <fog_pars_fragment>
		#include <logdepthbuf_pars_fragment>
		#include <clipping_planes_pars_fragment>

		vec2 closestLineToLine(vec3 p1, vec3 p2, vec3 p3, vec3 p4) {

			float mua;
			float mub;

			vec3 p13 = p1 - p3;
			vec3 p43 = p4 - p3;

			vec3 p21 = p2 - p1;

			float d1343 = dot( p13, p43 );
			float d4321 = dot( p43, p21 );
			float d1321 = dot( p13, p21 );
			float d4343 = dot( p43, p43 );
			float d2121 = dot( p21, p21 );

			float denom = d2121 * d4343 - d4321 * d4321;

			float numer = d1343 * d4321 - d1321 * d4343;

			mua = numer / denom;
			mua = clamp( mua, 0.0, 1.0 );
			mub = ( d1343 + d4321 * ( mua ) ) / d4343;
			mub = clamp( mub, 0.0, 1.0 );

			return vec2( mua, mub );

		}

		void main() {

			float alpha = opacity;
			vec4 diffuseColor = vec4( diffuse, alpha );

			#include <clipping_planes_fragment>

			#ifdef USE_DASH

				if ( vUv.y < - 1.0 || vUv.y > 1.0 ) discard; // discard endcaps

				if ( mod( vLineDistance + dashOffset, dashSize + gapSize ) > dashSize ) discard; // todo - FIX

			#endif

			#ifdef WORLD_UNITS

				float len;

				if ( isOrthographic ) {

					// View rays are parallel to the z axis so the distance reduces to camera-space XY
					vec2 lineDir = worldEnd.xy - worldStart.xy;
					float t = clamp( dot( worldPos.xy - worldStart.xy, lineDir ) / dot( lineDir, lineDir ), 0.0, 1.0 );
					len = length( worldStart.xy + lineDir * t - worldPos.xy );

				} else {

					// Find the closest points on the view ray and the line segment
					vec3 rayEnd = normalize( worldPos.xyz ) * 1e5;
					vec3 lineDir = worldEnd - worldStart;
					vec2 params = closestLineToLine( worldStart, worldEnd, vec3( 0.0, 0.0, 0.0 ), rayEnd );

					vec3 p1 = worldStart + lineDir * params.x;
					vec3 p2 = rayEnd * params.y;
					vec3 delta = p1 - p2;
					len = length( delta );

				}

				float norm = len / linewidth;

				#ifndef USE_DASH

					#ifdef USE_ALPHA_TO_COVERAGE

						float dnorm = fwidth( norm );
						alpha = 1.0 - smoothstep( 0.5 - dnorm, 0.5 + dnorm, norm );

					#else

						if ( norm > 0.5 ) {

							discard;

						}

					#endif

				#endif

			#else

				#ifdef USE_ALPHA_TO_COVERAGE

					// artifacts appear on some hardware if a derivative is taken within a conditional
					float a = vUv.x;
					float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
					float len2 = a * a + b * b;
					float dlen = fwidth( len2 );

					if ( abs( vUv.y ) > 1.0 ) {

						alpha = 1.0 - smoothstep( 1.0 - dlen, 1.0 + dlen, len2 );

					}

				#else

					if ( abs( vUv.y ) > 1.0 ) {

						float a = vUv.x;
						float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
						float len2 = a * a + b * b;

						if ( len2 > 1.0 ) discard;

					}

				#endif

			#endif

			#include <logdepthbuf_fragment>
			#include <color_fragment>

			gl_FragColor = vec4( diffuseColor.rgb, alpha );

			#include <tonemapping_fragment>
			#include <colorspace_fragment>
			#include <fog_fragment>
			#include <premultiplied_alpha_fragment>

		}
		`};var ar=class extends Ti{constructor(e){super({type:"LineMaterial",uniforms:al.clone(ni.line.uniforms),vertexShader:ni.line.vertexShader,fragmentShader:ni.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0!==this.worldUnits&&(this.needsUpdate=!0),e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var Ff=new Dt,b_=new X,w_=new X,Dn=new Dt,Nn=new Dt,cs=new Dt,Of=new X,Bf=new Ot,Un=new Za,E_=new X,qh=new xi,Yh=new zi,hs=new Dt,us,Br;function T_(n,e,t){return hs.set(0,0,-e,1).applyMatrix4(n.projectionMatrix),hs.multiplyScalar(1/hs.w),hs.x=Br/t.width,hs.y=Br/t.height,hs.applyMatrix4(n.projectionMatrixInverse),hs.multiplyScalar(1/hs.w),Math.abs(Math.max(hs.x,hs.y))}function DE(n,e){let t=n.matrixWorld,i=n.geometry,s=i.attributes.instanceStart,r=i.attributes.instanceEnd,o=Math.min(i.instanceCount,s.count);for(let a=0,l=o;a<l;a++){Un.start.fromBufferAttribute(s,a),Un.end.fromBufferAttribute(r,a),Un.applyMatrix4(t);let c=new X,h=new X;us.distanceSqToSegment(Un.start,Un.end,h,c),h.distanceTo(c)<Br*.5&&e.push({point:h,pointOnLine:c,distance:us.origin.distanceTo(h),object:n,face:null,faceIndex:a,uv:null,uv1:null})}}function NE(n,e,t){let i=e.projectionMatrix,r=n.material.resolution,o=n.matrixWorld,a=n.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,h=Math.min(a.instanceCount,l.count),d=-e.near;us.at(1,cs),cs.w=1,cs.applyMatrix4(e.matrixWorldInverse),cs.applyMatrix4(i),cs.multiplyScalar(1/cs.w),cs.x*=r.x/2,cs.y*=r.y/2,cs.z=0,Of.copy(cs),Bf.multiplyMatrices(e.matrixWorldInverse,o);for(let u=0,m=h;u<m;u++){if(Dn.fromBufferAttribute(l,u),Nn.fromBufferAttribute(c,u),Dn.w=1,Nn.w=1,Dn.applyMatrix4(Bf),Nn.applyMatrix4(Bf),Dn.z>d&&Nn.z>d)continue;if(Dn.z>d){let P=Dn.z-Nn.z,y=(Dn.z-d)/P;Dn.lerp(Nn,y)}else if(Nn.z>d){let P=Nn.z-Dn.z,y=(Nn.z-d)/P;Nn.lerp(Dn,y)}Dn.applyMatrix4(i),Nn.applyMatrix4(i),Dn.multiplyScalar(1/Dn.w),Nn.multiplyScalar(1/Nn.w),Dn.x*=r.x/2,Dn.y*=r.y/2,Nn.x*=r.x/2,Nn.y*=r.y/2,Un.start.copy(Dn),Un.start.z=0,Un.end.copy(Nn),Un.end.z=0;let x=Un.closestPointToPointParameter(Of,!0);Un.at(x,E_);let f=ol.lerp(Dn.z,Nn.z,x),p=f>=-1&&f<=1,M=Of.distanceTo(E_)<Br*.5;if(p&&M){Un.start.fromBufferAttribute(l,u),Un.end.fromBufferAttribute(c,u),Un.start.applyMatrix4(o),Un.end.applyMatrix4(o);let P=new X,y=new X;us.distanceSqToSegment(Un.start,Un.end,y,P),t.push({point:y,pointOnLine:P,distance:us.origin.distanceTo(y),object:n,face:null,faceIndex:u,uv:null,uv1:null})}}}var $h=class extends zn{constructor(e=new Yo,t=new ar({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,i=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)b_.fromBufferAttribute(t,o),w_.fromBufferAttribute(i,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+b_.distanceTo(w_);let r=new tr(s,2,1);return e.setAttribute("instanceDistanceStart",new Vi(r,1,0)),e.setAttribute("instanceDistanceEnd",new Vi(r,1,1)),this}raycast(e,t){let i=this.material.worldUnits,s=e.camera;if(s===null&&!i&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),i===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;us=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;Br=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),Yh.copy(a.boundingSphere).applyMatrix4(o);let c;if(i)c=Br*.5;else{let d=Math.max(s.near,Yh.distanceToPoint(us.origin));c=T_(s,d,l.resolution)}if(Yh.radius+=c,us.intersectsSphere(Yh)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),qh.copy(a.boundingBox).applyMatrix4(o);let h;if(i)h=Br*.5;else{let d=Math.max(s.near,qh.distanceToPoint(us.origin));h=T_(s,d,l.resolution)}qh.expandByScalar(h),us.intersectsBox(qh)!==!1&&(i?DE(this,t):NE(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(Ff),this.material.uniforms.resolution.value.set(Ff.z,Ff.w))}};var kr=class extends Yo{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(e){let t=e.length-3,i=new Float32Array(2*t);for(let s=0;s<t;s+=3)i[2*s]=e[s],i[2*s+1]=e[s+1],i[2*s+2]=e[s+2],i[2*s+3]=e[s+3],i[2*s+4]=e[s+4],i[2*s+5]=e[s+5];return super.setPositions(i),this}setColors(e){let t=e.length-3,i=new Float32Array(2*t);for(let s=0;s<t;s+=3)i[2*s]=e[s],i[2*s+1]=e[s+1],i[2*s+2]=e[s+2],i[2*s+3]=e[s+3],i[2*s+4]=e[s+4],i[2*s+5]=e[s+5];return super.setColors(i),this}setFromPoints(e){let t=e.length-1,i=new Float32Array(6*t);for(let s=0;s<t;s++)i[6*s]=e[s].x,i[6*s+1]=e[s].y,i[6*s+2]=e[s].z||0,i[6*s+3]=e[s+1].x,i[6*s+4]=e[s+1].y,i[6*s+5]=e[s+1].z||0;return super.setPositions(i),this}fromLine(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}};var Zh=class extends $h{constructor(e=new kr,t=new ar({color:Math.random()*16777215})){super(e,t),this.isLine2=!0,this.type="Line2"}};var UE=new X(0,1,0),FE=new Oo(1,1,1,40),OE=new ka(1,32,20),BE=new Js(1,1,1),kE=new Ba(1,1,24);function ds(n){return new Bo({color:n,roughness:.55,metalness:.08})}function jh(n,e,t=!0){let i=new zn(n,e);return i.castShadow=t,i.receiveShadow=t,i}var Ls=(n,e)=>jh(FE,n,e),zr=n=>jh(OE,n),Jh=n=>jh(BE,n),A_=n=>jh(kE,n,!1);function lr(n,e,t,i){let s=Pt(t,e),r=Gt(s);n.visible=r>1e-9,n.visible&&(n.position.set(...Oe(e,be(s,.5))),n.quaternion.setFromUnitVectors(UE,new X(...be(s,1/r))),n.scale.set(i,r,i))}function dl(n,e,t,i,s){let r=be(t,i/2);lr(n,Pt(e,r),Oe(e,r),s)}function Kh(n,e,t,[i,s,r]){n.position.set(...e);let o=[...t.x,0,...t.y,0,...t.z,0,0,0,0,1];n.quaternion.setFromRotationMatrix(new Ot().fromArray(o)),n.scale.set(i,s,r)}function $o(n,e,t=!1){let i=new Zh(new kr,new ar({color:n,linewidth:e}));return i.frustumCulled=!1,t&&(i.material.depthTest=!1,i.material.transparent=!0,i.renderOrder=2),i}function Qh(n,e){n.visible=e.length>1,n.visible&&(n.geometry.dispose(),n.geometry=new kr,n.geometry.setPositions(e.flat()))}function R_(){let n=document.createElement("canvas");[n.width,n.height]=[8,4];let e=n.getContext("2d");for(let i=0;i<4;i++)for(let s=0;s<2;s++)e.fillStyle=(i+s)%2===0?"#111418":"#ffffff",e.fillRect(2*i,2*s,2,2);let t=new Ua(n);return t.colorSpace=Zn,t.magFilter=gn,new Bo({map:t,roughness:.6})}function C_(n,e){let{x:t,y:i,z:s,half:r}=Ml(e);return{x:ks(n,t),y:ks(n,i),z:ks(n,s),o:_r(n,e.com),half:r}}function P_(){let n=ds("#5c6673");Object.assign(n,{transparent:!0,opacity:.5,depthWrite:!1});let e=Jh(n);return{mesh:e,put(t,i){let{half:s,...r}=C_(t,i),o=Math.max(...s);Kh(e,r.o,r,s.map(a=>2*Math.max(a,.02*o))),e.visible=o>0}}}function I_(n,e){let{x:t,y:i,z:s,o:r,half:o}=C_(n,e),a=[t,i,s].map((l,c)=>be(l,o[c]));return[-1,1].flatMap(l=>[-1,1].flatMap(c=>[-1,1].map(h=>Oe(r,Oe(Oe(be(a[0],l),be(a[1],c)),be(a[2],h))))))}var zE=["#e03131","#2f9e44","#1c7ed6"];function VE(){let n=new Jn,e=zE.map(i=>{let s=ds(i),[r,o]=[Ls(s,!1),A_(s)];return n.add(r,o),{rod:r,head:o}});return{group:n,put:(i,s)=>{[i.x,i.y,i.z].forEach((r,o)=>{let[a,l]=[.78,1].map(c=>Oe(i.o,be(r,c*s)));lr(e[o].rod,i.o,a,.032*s),lr(e[o].head,a,l,.085*s)})}}}function cr(n){let e=n.rows.map((t,i)=>({row:t,index:i}));return n.isMounted?e.filter(({row:t})=>t.mount!==null):e}function L_(n,e,t){let i=cr(e),s=.034*t/Math.sqrt(Math.max(1,i.length/6)),r=_=>s*(1-.45*_/Math.max(i.length,4)),o=ds("#c9d1db"),a=ds("#5c6673"),l=new Jn;n.scene.add(l);let c=(_,v=l)=>(v.add(_),_),h=e.floating?null:{disc:c(Ls(a)),post:c(Ls(a))},d=e.floating&&P_();d&&c(d.mesh);let u=i.map(({row:_})=>{let v=ds("#888888");return{color:v,body:_.isPlace?null:c(_.type==="prismatic"?Jh(v):Ls(v)),caps:_.isPlace||_.type==="prismatic"?[]:[0,1].map(()=>c(Ls(a))),rods:[0,1].map(()=>c(Ls(o))),corners:[0,1].map(()=>c(zr(o)))}}),m=e.tips.map(()=>({rod:c(Ls(o)),ball:c(zr(a)),stub:c(Ls(o))})),g=c(new Jn),x=[...i,"base","world",...e.tips].map(()=>{let _=VE();return g.add(_.group),_}),f=c(new Jn),p=i.map(({row:_})=>{let v=$o("#888888",1.6);return v.material.dashed=!0,f.add(v),v.visible=!_.isPlace,v}),M=c(new Jn),P=R_(),y=[...e.rows,...e.tips,...e.floating?[e.floating]:[]].map(()=>c(zr(P),M)),A=c(zr(ds("#f08c00")),M);function b(_,v,D){let{row:C,index:E}=i[v],{middle:L,frame:F,link:I,origin:O,axis:V,before:k}=_.rows[E],{body:K,caps:Y,rods:Z,corners:te}=u[v],le=r(v),ce=e.isMounted?I.o:L.o,ee=e.isMounted?I.o:F.o;if(lr(Z[0],D,ce,.52*le),lr(Z[1],ce,ee,.52*le),[ce,ee].forEach((me,_e)=>{te[_e].position.set(...me),te[_e].scale.setScalar(.52*le)}),!K)return ee;if(C.type==="prismatic"){let me=e.convention==="standard"?k:L;Kh(K,e.isMounted?D:O,{...me,z:V},[1.7*le,1.7*le,3.4*le])}else{let me=e.isMounted?I.o:e.convention==="standard"?O:F.o;dl(K,me,V,2.5*le,le),Y.forEach((_e,oe)=>{dl(_e,Oe(me,be(V,(oe===0?1.3:-1.3)*le)),V,.12*le,.5*le)})}return ee}return{paint(_){u.forEach(({color:v},D)=>{v.color.set(_(i[D].row)),p[D].material.color.set(_(i[D].row))}),n.ask()},show({frames:_,axes:v,masses:D}){g.visible=_,f.visible=v,M.visible=D,o.transparent=D,o.opacity=D?.45:1,n.ask()},put(_,v){let D=r(0),C=_.base.o;d?.put(_.base,v.floating),h&&dl(h.disc,Pt(C,be(_.base.z,1.75*D)),_.base.z,.9*D,1.9*D),h&&dl(h.post,Pt(C,be(_.base.z,1.1*D)),_.base.z,.6*D,1.25*D);let E=new Map([[null,C]]);i.forEach(({row:K,index:Y},Z)=>E.set(Y,b(_,Z,E.get(K.on)??C)));let L=r(i.length);m.forEach((K,Y)=>{let{on:Z}=v.tips[Y],[te,le]=[E.get(Z)??C,_.tips[Y].o];lr(K.rod,te,le,.45*L),K.ball.position.set(...le),K.ball.scale.setScalar(.62*L);let ce=Z===null?_.base:_.rows[Z].link,ee=Z!==null&&v.convention==="modified"&&Qi(te,le)<.01*t;lr(K.stub,ce.o,ee?_r(ce,v.rows[Z].com):ce.o,.45*L)});let F=.13*t;i.forEach(({index:K},Y)=>x[Y].put(_.rows[K].link,F)),x[i.length].put(_.base,1.15*F),x[i.length+1].put({x:[1,0,0],y:[0,1,0],z:[0,0,1],o:[0,0,0]},1.5*F),_.tips.forEach((K,Y)=>x[i.length+2+Y].put(K,F)),i.forEach(({row:K,index:Y},Z)=>{if(K.isPlace)return;let{origin:te,axis:le,link:ce}=_.rows[Y],ee=e.isMounted?ce.o:te;Qh(p[Z],[-.16,.16].map(me=>Oe(ee,be(le,me*t))))});let[I,O]=[0,[0,0,0]],V=v.rows.map((K,Y)=>({...K,frame:_.rows[Y].link}));v.tips.forEach(({on:K,body:Y},Z)=>V.push({...K===null&&!v.floating?null:Y,frame:_.tips[Z]})),v.floating&&V.push({...v.floating,frame:_.base}),y.forEach((K,Y)=>{let Z=V[Y];if(K.visible=Z.mass>0,!K.visible)return;let te=_r(Z.frame,Z.com);K.position.set(...te),I+=Z.mass,O=Oe(O,be(te,Z.mass))});let k=Math.max(...V.map(K=>K.mass??0));y.forEach((K,Y)=>{K.visible&&K.scale.setScalar(.034*t*Math.cbrt(V[Y].mass/k))}),A.visible=I>0,I>0&&A.position.set(...be(O,1/I)),A.scale.setScalar(.02*t),n.ask()}}}function kf(n,e,t){let i=[e.base.o,...e.tips.map(r=>r.o)];for(let{index:r}of cr(n)){let{middle:o,link:a}=e.rows[r];i.push(a.o),n.isMounted||i.push(o.o)}n.floating&&i.push(...I_(e.base,n.floating));for(let{on:r}of n.tips)r!==null&&i.push(_r(e.rows[r].link,n.rows[r].com));let s=.05*t;return i.flatMap(r=>[r,...[0,1,2].flatMap(o=>[-s,s].map(a=>r.map((l,c)=>c===o?l+a:l)))])}var hr={theta:"#e64980",d:"#228be6",a:"#37b24d",alpha:"#f76707"},D_={theta:"\u03B8",d:"d",a:"a",alpha:"\u03B1"},U_="#868e96";function N_(n,e,t,i,s){let r=Math.max(2,Math.ceil(Math.abs(i)/.06)),o=be(On(Pt(t,be(e,hi(e,t)))),s);return Array.from({length:r+1},(a,l)=>Oe(n,gr(o,e,i*l/r)))}function GE(n,e){let t=n[n.length-1],i=On(Pt(t,n[n.length-2])),s=On(fn(i,Math.abs(i[2])<.9?[0,0,1]:[1,0,0]));return[1,-1].map(r=>Oe(t,Oe(be(i,-e),be(s,.4*r*e))))}function HE(n,e,t,i,s){let r=n.rows[t],{before:o,middle:a,frame:l,theta:c,d:h}=e.rows[t],d=n.convention==="standard",u=.115*s,m=t+1,g={paths:[],texts:[]},x=(C,E,L,F)=>{g.paths.push({color:hr[C],path:E,width:3.2});let[I,O]=GE(E,.03*s),V=E[E.length-1];g.paths.push({color:hr[C],path:[I,V,O],width:3.2});let k=!d&&(C==="a"||C==="alpha")?m-1:m;g.texts.push({at:L,name:C,sign:D_[C],index:k,text:F})},f=(C,E)=>g.paths.push({color:U_,path:[C,E],width:1.4}),p=C=>C[Math.floor(C.length/2)],[M,P]=d?[o,a]:[a,l],[y,A]=d?[a,l]:[o,a],b=d?M.o:P.o,_=d?A.o:y.o,v=C=>Math.abs(C)<1e-9,D=M.z;for(let C of[M.x,P.x])f(b,Oe(b,be(C,1.25*u)));if(v(c))g.texts.push({at:Oe(b,be(P.x,1.3*u)),name:"theta",sign:D_.theta,index:m,text:i.angle(0)});else{let C=N_(b,D,M.x,c,u),E=On(Pt(p(C),b));x("theta",C,Oe(b,be(E,1.2*u)),i.angle(c))}if(Math.abs(h)>1e-9&&x("d",[M.o,P.o],be(Oe(M.o,P.o),.5),i.length(h)),Math.abs(r.a)>1e-9&&x("a",[y.o,A.o],be(Oe(y.o,A.o),.5),i.length(r.a)),!v(r.alpha)){for(let L of[y.z,A.z])f(_,Oe(_,be(L,1.25*u)));let C=N_(_,y.x,y.z,r.alpha,u),E=On(Pt(p(C),_));x("alpha",C,Oe(_,be(E,1.2*u)),i.angle(r.alpha))}return g}function WE(n,e,t,i,s,r){let{link:o,axis:a}=e.rows[t],l={paths:[],texts:[]},c=[i.o,o.o];if(Qi(...c)>1e-9){l.paths.push({color:hr.a,path:c,width:3.2});let d=Pt(o.o,i.o),u=[i.x,i.y,i.z].map(m=>s.number(hi(m,d)));l.texts.push({at:be(Oe(...c),.5),name:"a",sign:"xyz",index:null,text:`${u.join(", ")} m`})}let h=Oe(o.o,be(a,.2*r));return l.paths.push({color:hr.theta,path:[o.o,h],width:3.2}),l.texts.push({at:h,name:"theta",sign:"axis",index:null,text:""}),l}function F_(n,e,t){let i=new Jn;n.scene.add(i);let s=[],r=cr(e);return{put(o,a,l,c){let h=l.map(u=>{if(!e.isMounted)return HE(a,o,u,c,t);let m=r.findIndex(x=>x.index===u),g=m>0?o.rows[r[m-1].index].link:o.base;return WE(a,o,u,g,c,t)}),d=h.flatMap(({paths:u})=>u);for(;s.length<d.length;){let u=$o(U_,1,!0);i.add(u),s.push(u)}return s.forEach((u,m)=>{u.visible=m<d.length,u.visible&&(Qh(u,d[m].path),u.material.color.set(d[m].color),u.material.linewidth=d[m].width)}),n.ask(),h.flatMap(({texts:u})=>u)}}}var XE=24;function O_(n,e,t){let{state:i,size:s}=n,r=zr(ds("#f08c00"));r.scale.setScalar(s/45),e.scene.add(r);function o(){r.visible=i.mode==="reach",r.visible&&r.position.set(...i.target.slice(0,3)),e.ask()}let a=({clientX:d,clientY:u})=>{let{left:m,top:g}=e.canvas.getBoundingClientRect();return[d-m,u-g]},[l,c]=[null,null];t.addEventListener("pointerdown",d=>{if(i.mode!=="reach"||d.target!==e.canvas)return;let u=e.onCanvas(i.target.slice(0,3));!u||Qi([...u,0],[...a(d),0])>XE||(l=d.pointerId,e.hold(!0),e.canvas.setPointerCapture(l))},!0),t.addEventListener("pointermove",d=>{if(d.pointerId!==l)return;let u=c!==null;c=a(d),u||requestAnimationFrame(h)});function h(){c!==null&&(e.under(c,i.target.slice(0,3)).forEach((d,u)=>i.target[u]=d),c=null,n.seek(!0))}for(let d of["pointerup","pointercancel"])t.addEventListener(d,u=>{u.pointerId===l&&(h(),l=null,e.hold(!1),n.seek())});e.onDraw(()=>{r.visible&&(t.dataset.handle=e.onCanvas(i.target.slice(0,3))?.map(Math.round).join(" "))}),n.on("reached mode",o),o()}var fl=2;function B_(n,e){let t=[],i=[];function s(){let r=[],{clientWidth:o,clientHeight:a}=e;t.forEach(({at:l},c)=>{let h=i[c],d=n.onCanvas(l);if(h.hidden=d===null,!d)return;let[u,m]=[h.offsetWidth,h.offsetHeight],g=Math.min(Math.max(d[0]-u/2,2),o-u-2),x=Math.min(Math.max(d[1]-m/2,2),a-m-2);for(let f=0;f<12;f++){let p=r.find(M=>!(g>M.x+M.wide+fl||M.x>g+u+fl)&&x<M.y+M.high+fl&&M.y<x+m+fl);if(!p)break;x=p.y+p.high+fl+.5}r.push({x:g,y:x,wide:u,high:m}),h.style.transform=`translate(${g}px, ${x}px)`})}return n.onDraw(s),{put(r){for(t=r;i.length<r.length;)i.push(e.appendChild(z("span")));i.forEach((o,a)=>{if(o.hidden=a>=r.length,o.hidden)return;let{content:l,kind:c,color:h}=r[a];o.className=`label ${c}`,o.style.setProperty("--color",h),o.replaceChildren(...[l].flat())}),n.ask()}}}var k_={type:"change"},Vf={type:"start"},V_={type:"end"},eu=new Ir,z_=new gi,qE=Math.cos(70*ol.DEG2RAD),bn=new X,ri=2*Math.PI,Rt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},zf=1e-6,tu=class extends Ja{constructor(e,t=null){super(e,t),this.state=Rt.NONE,this.target=new X,this.cursor=new X,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:nr.ROTATE,MIDDLE:nr.DOLLY,RIGHT:nr.PAN},this.touches={ONE:ir.ROTATE,TWO:ir.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new X,this._lastQuaternion=new Qn,this._lastTargetPosition=new X,this._quat=new Qn().setFromUnitVectors(e.up,new X(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new zo,this._sphericalDelta=new zo,this._scale=1,this._panOffset=new X,this._rotateStart=new Ke,this._rotateEnd=new Ke,this._rotateDelta=new Ke,this._panStart=new Ke,this._panEnd=new Ke,this._panDelta=new Ke,this._dollyStart=new Ke,this._dollyEnd=new Ke,this._dollyDelta=new Ke,this._dollyDirection=new X,this._mouse=new Ke,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=$E.bind(this),this._onPointerDown=YE.bind(this),this._onPointerUp=ZE.bind(this),this._onContextMenu=nT.bind(this),this._onMouseWheel=KE.bind(this),this._onKeyDown=QE.bind(this),this._onTouchStart=eT.bind(this),this._onTouchMove=tT.bind(this),this._onMouseDown=jE.bind(this),this._onMouseMove=JE.bind(this),this._interceptControlDown=iT.bind(this),this._interceptControlUp=sT.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Rt.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(k_),this.update(),this.state=Rt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;bn.copy(t).sub(this.target),bn.applyQuaternion(this._quat),this._spherical.setFromVector3(bn),this.autoRotate&&this.state===Rt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ri:i>Math.PI&&(i-=ri),s<-Math.PI?s+=ri:s>Math.PI&&(s-=ri),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(bn.setFromSpherical(this._spherical),bn.applyQuaternion(this._quatInverse),t.copy(this.target).add(bn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=bn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new X(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new X(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=bn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(eu.origin.copy(this.object.position),eu.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(eu.direction))<qE?this.object.lookAt(this.target):(z_.setFromNormalAndCoplanarPoint(this.object.up,this.target),eu.intersectPlane(z_,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>zf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>zf||this._lastTargetPosition.distanceToSquared(this.target)>zf?(this.dispatchEvent(k_),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?ri/60*this.autoRotateSpeed*e:ri/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){bn.setFromMatrixColumn(t,0),bn.multiplyScalar(-e),this._panOffset.add(bn)}_panUp(e,t){this.screenSpacePanning===!0?bn.setFromMatrixColumn(t,1):(bn.setFromMatrixColumn(t,0),bn.crossVectors(this.object.up,bn)),bn.multiplyScalar(e),this._panOffset.add(bn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;bn.copy(s).sub(this.target);let r=bn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ri*this._rotateDelta.x/t.clientHeight),this._rotateUp(ri*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ri*this._rotateDelta.x/t.clientHeight),this._rotateUp(ri*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Ke,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function YE(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function $E(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function ZE(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(V_),this.state=Rt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function jE(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case nr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Rt.DOLLY;break;case nr.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Rt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Rt.ROTATE}break;case nr.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Rt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Rt.PAN}break;default:this.state=Rt.NONE}this.state!==Rt.NONE&&this.dispatchEvent(Vf)}function JE(n){switch(this.state){case Rt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Rt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Rt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function KE(n){this.enabled===!1||this.enableZoom===!1||this.state!==Rt.NONE||(n.preventDefault(),this.dispatchEvent(Vf),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(V_))}function QE(n){this.enabled!==!1&&this._handleKeyDown(n)}function eT(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case ir.ROTATE:if(this.enableRotate===!1){this.state=Rt.NONE;break}this._handleTouchStartRotate(n),this.state=Rt.TOUCH_ROTATE;break;case ir.PAN:if(this.enablePan===!1){this.state=Rt.NONE;break}this._handleTouchStartPan(n),this.state=Rt.TOUCH_PAN;break;default:this.state=Rt.NONE}break;case 2:switch(this.touches.TWO){case ir.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Rt.TOUCH_DOLLY_PAN;break;case ir.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Rt.TOUCH_DOLLY_ROTATE;break;default:this.state=Rt.NONE}break;default:this.state=Rt.NONE}this.state!==Rt.NONE&&this.dispatchEvent(Vf)}function tT(n){switch(this._trackPointer(n),this.state){case Rt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Rt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Rt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Rt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Rt.NONE}}function nT(n){this.enabled!==!1&&n.preventDefault()}function iT(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function sT(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Gf(n){let e=Math.abs(n[0])<.9?[1,0,0]:[0,1,0],t=On(Pt(e,be(n,hi(e,n))));return[t,fn(n,t)]}function G_(n,e,t){let i;try{i=new Gh({canvas:n,antialias:!0,alpha:!0})}catch{return null}i.shadowMap.enabled=!0;let s=new Pa,r=new jn(32,1,t/100,t*60);r.up.set(...e);let o=new tu(r,n);o.enableDamping=!1,o.minDistance=t/10,o.maxDistance=t*20;let a=new Wa(16777215,9279912,1.6);a.position.set(...e);let[l,c]=Gf(e),h=new Ya(16777215,2.2),d=Oe(Oe(be(e,2.2),be(l,.9)),be(c,-1.1));h.castShadow=!0,h.shadow.mapSize.set(1024,1024),h.shadow.radius=5,h.shadow.bias=-5e-4,h.shadow.normalBias=t/200,Object.assign(h.shadow.camera,{left:-1.6*t,right:1.6*t,top:1.6*t,bottom:-1.6*t,near:.1*t,far:8*t}),s.add(a,h,h.target);let u=new Qn().setFromUnitVectors(new X(0,0,1),new X(...e)),m=new zn(new Lr(12*t,12*t),new Va({opacity:.16}));m.quaternion.copy(u),m.receiveShadow=!0,s.add(m);let g=null,x=!1,f=[],p=()=>{x=!1,i.render(s,r),f.forEach(y=>y())},M=()=>{x||requestAnimationFrame(p),x=!0};o.addEventListener("change",M);let P=()=>{let{clientWidth:y,clientHeight:A}=n;y===0||A===0||(i.setPixelRatio(Math.min(devicePixelRatio,2)),i.setSize(y,A,!1),r.aspect=y/A,r.updateProjectionMatrix(),M())};return new ResizeObserver(P).observe(n),{scene:s,camera:r,canvas:n,ask:M,onDraw:y=>f.push(y),ground(y,A,b,_=!0){m.visible=_;let v=Oe(y,be(e,A-hi(y,e)));m.position.set(...v),h.target.position.set(...y),h.position.set(...Oe(y,be(On(d),4*t))),g&&s.remove(g);let D=10**Math.floor(Math.log10(t/2)),C=[1,2,5,10].map(L=>L*D).find(L=>L>=t/8),E=2*Math.ceil(2*t/C);return g=new ja(E*C,E,new ht(b[0]),new ht(b[1])),g.quaternion.setFromUnitVectors(new X(0,1,0),new X(...e)),g.position.set(...Oe(v,be(e,-t/500))),s.add(g),M(),C},look(y,A){P();let _=[0,1,2].map(L=>A.map(F=>F[L])).map(L=>(Math.min(...L)+Math.max(...L))/2),v=Math.max(...A.map(L=>Gt(Pt(L,_))),t/8),D=r.fov*Math.PI/360,C=Math.min(D,Math.atan(Math.tan(D)*r.aspect)),E=1.12*v/Math.sin(C);r.position.set(...Oe(_,be(On(y),E))),o.target.set(..._),o.update(),M()},follow(y){for(let{position:A}of[r,h,h.target])A.set(...Oe(A.toArray(),y));o.target.set(...Oe(o.target.toArray(),y)),o.update(),M()},turn(y,A){let b=o.target.toArray(),_=Pt(r.position.toArray(),b),v=On(fn(e,_)),D=gr(gr(_,e,y),v,-A);Gt(fn(On(D),e))<.05||(r.position.set(...Oe(b,D)),o.update(),M())},zoom(y){let A=o.target.toArray(),b=Pt(r.position.toArray(),A);r.position.set(...Oe(A,be(b,y))),o.update(),M()},under([y,A],b){let{clientWidth:_,clientHeight:v}=n,{z:D}=new X(...b).project(r);return new X(2*y/_-1,1-2*A/v,D).unproject(r).toArray()},hold(y){o.enabled=!y},onCanvas(y){let A=new X(...y).project(r);if(A.z>1)return null;let{clientWidth:b,clientHeight:_}=n;return[(A.x+1)/2*b,(1-A.y)/2*_]}}}var rT=[.1,.25,.5,1,2],H_={play:"M7 4.5v15l12.5-7.5z",pause:"M6.5 4.5h4v15h-4zM13.5 4.5h4v15h-4z"};function oT(n){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let t=document.createElementNS("http://www.w3.org/2000/svg","path");return t.setAttribute("d",n),e.append(t),e}function W_(n){let{state:e}=n,t=z("button",{type:"button",class:"play","data-key":"play"}),i=z("input",{type:"range",min:0,step:"any","data-key":"time","aria-label":"Time"}),s=z("output",{class:"time","data-key":"seconds"}),r=z("select",{"aria-label":"Speed","data-key":"speed"},rT.map(u=>z("option",{value:u,selected:u===1},`${u}\xD7`))),o=z("input",{type:"checkbox","data-key":"repeat"}),a=null;function l(u){if(!e.isPlaying){a=null;return}if(a!==null){let{duration:m}=n.trajectory,g=e.t+(u-a)/1e3*e.speed;g>=m&&o.checked&&m>0&&(g%=m),g>=m&&n.play(!1),n.setTime(g)}a=u,requestAnimationFrame(l)}function c(){t.replaceChildren(oT(e.isPlaying?H_.pause:H_.play)),t.setAttribute("aria-label",e.isPlaying?"Pause":"Play"),e.isPlaying&&a===null&&requestAnimationFrame(l)}function h(){let{duration:u}=n.trajectory??{duration:0};i.max=u,i.value=e.t;let m=`${e.t.toFixed(2)} / ${u.toFixed(2)} s`;i.setAttribute("aria-valuetext",m),s.textContent=m,d.hidden=n.trajectory===null}t.addEventListener("click",()=>n.play(!e.isPlaying)),i.addEventListener("input",()=>{n.play(!1),n.setTime(Number(i.value))}),r.addEventListener("change",()=>e.speed=Number(r.value));let d=z("div",{class:"transport",role:"group","aria-label":"Time"},t,i,s,r,z("label",{class:"check"},o,"repeat"));return n.on("play",c),n.on("time trajectory",h),c(),h(),d}function aT(n){return Gt(n.gravity)>1e-9?On(be(n.gravity,-1)):[0,0,1]}function lT(n,e){if(n.floating)return null;let{rows:t}=Ii(n,new Array(n.joints).fill(0),null),i=n.rows.flatMap((o,a)=>o.type==="revolute"&&o.joint!==null?[t[a].axis]:[]);if(i.length===0)return null;let[s]=i;return i.every(o=>Gt(fn(s,o))<1e-6)&&Math.abs(hi(s,e))<1e-6?s:null}function X_(n){let{table:e,state:t,size:i}=n,s=z("canvas",{tabIndex:0,role:"img"}),r=z("div",{class:"labels","aria-hidden":"true"}),o=z("output",{class:"readout"}),a=z("span",{class:"scale"}),l=z("div",{class:"views",role:"group","aria-label":"View"}),c=z("div",{class:"shown",role:"group","aria-label":"What is shown"}),h=z("div",{class:"view"},s,r,l,o,a),d=z("section",{class:"panel stage","aria-label":"The arm"},h,c,W_(n));s.setAttribute("aria-label",`${e.name} in 3D; drag to turn, arrow keys too, plus and minus to zoom`);function u(){let f=aT(e),p=G_(s,f,i);if(!p){h.classList.add("missing"),h.append(z("p",{},"This browser draws no WebGL: the arm is not shown. All numbers are."));return}let M=L_(p,e,i),P=F_(p,e,i),y=B_(p,r);O_(n,p,h);let A=cr(e),b=$o("#f08c00",2.4);b.visible=!1,p.scene.add(b);let _=lT(e,f),[v,D]=Gf(f),C=_??be(D,-1),E=fn(f,C),F={"3D":_?Oe(Oe(C,be(E,.22)),be(f,.16)):Oe(Oe(be(v,.75),be(D,-.9)),be(f,.55)),front:Oe(C,be(f,1e-4)),side:Oe(E,be(f,1e-4)),top:Oe(f,be(C,.001))},I="3D";function O(oe,de,Ne){let $e=Ii(n.table,de,oe),Be=Y()?Pt(Ne,$e.base.o):[0,0,0];return kf(n.table,$e,i).map(st=>Oe(st,Be))}function V(oe){I=oe;let de=n.trajectory??{q:[],base:[]},Ne=Math.max(1,Math.floor(de.q.length/12)),$e=n.frames().base.o,Be=de.q.flatMap((Xe,St)=>St%Ne===0||St===de.q.length-1?O(de.base[St],Xe,$e):[]).concat(O(n.start(),t.q,$e)).filter(Xe=>Qi(Xe,$e)<1.6*i);K=$e;let st=Ii(n.table,t.q,n.start()),at=e.floating?kf(n.table,st,i):Be;k=Math.min(...at.map(Xe=>hi(Xe,f)),hi(st.base.o,f)-.09*i),te(),p.look(F[oe],Be.length>0?Be:[$e])}let k=0,K=[0,0,0],Y=()=>e.floating!==null&&t.mode==="free"&&t.show.isFollowed;function Z(oe){Y()&&p.follow(Pt(oe,K)),K=oe}function te(){let{base:oe}=Ii(n.table,t.q,n.start()),de=e.floating!==null&&t.mode==="free",Ne=p.ground(oe.o,k,[Tr("--grid-strong"),Tr("--grid")],!de);a.textContent=`grid ${Ne>=1?Ne:Number(Ne.toPrecision(3))} m`}for(let oe of Object.keys(F))l.append(z("button",{type:"button",class:"chip","data-key":`view-${oe}`,onclick:()=>V(oe)},oe));s.addEventListener("keydown",({key:oe})=>{let de={ArrowLeft:[-.1,0],ArrowRight:[.1,0],ArrowUp:[0,.1],ArrowDown:[0,-.1]};de[oe]&&p.turn(...de[oe]),(oe==="+"||oe==="-")&&p.zoom(oe==="+"?.9:1/.9)});function le(){let{parameters:oe}=t.show;if(oe==="none")return[];let de=A.filter(({row:Ne})=>!Ne.isPlace).map(({index:Ne})=>Ne);return oe==="all"?de:de.filter(Ne=>Ne===t.selected)}function ce(){let oe=n.frames();Z(oe.base.o),M.put(oe,n.table);let de=P.put(oe,n.table,le(),n.units),Ne=t.show.frames?[{at:oe.base.o,content:"0",kind:"frame",color:"var(--ink)"},...A.map(({row:Xe,index:St},Ct)=>({at:oe.rows[St].link.o,content:Xe.isPlace?"tip":String(Ct+1),kind:"frame",color:"var(--ink)"})),...(e.tips.length>1?e.tips:[]).map(({name:Xe},St)=>({at:oe.tips[St].o,content:Xe,kind:"frame",color:"var(--ink)"}))]:[],$e=de.map(({at:Xe,name:St,sign:Ct,index:Kt,text:Et})=>({at:Xe,content:[...dn(Ct,Kt),Et?` = ${Et}`:""],kind:"parameter",color:hr[St]}));y.put([...Ne,...$e]);let[Be,st,at]=oe.tips[t.tip].o.map(Xe=>(Math.abs(Xe)<5e-7?0:Xe).toFixed(4));o.textContent=`${n.tip().name}  x ${Be}  y ${st}  z ${at} m`,me()}function ee(){let{trajectory:oe}=n,de=oe?.tip??[];b.visible=de.length>1,b.visible&&(b.geometry.dispose(),b.geometry=new b.geometry.constructor,b.geometry.setPositions(de.flat()),me())}function me(){let{trajectory:oe}=n;if(!oe||oe.t.length<2){b.visible=!1;return}let de=Math.floor(t.t/oe.duration*(oe.t.length-1)+1e-9);b.visible=t.show.trace&&de>0,b.geometry.instanceCount=de,p.ask()}function _e(){let oe=de=>de.joint??de.follows?.joint;M.paint(de=>Tr(oe(de)===void 0?"--muted":`--joint-${oe(de)%8}`)),b.material.color.set(Tr("--trace")),te()}n.on("time fields units selection tip",ce),n.on("trajectory",ee),n.on("show",()=>{M.show(t.show),ce()}),n.on("theme",_e),n.on("mode",()=>V(I)),M.show(t.show),V("3D"),_e(),ce(),ee(),requestAnimationFrame(()=>V("3D"))}let m=z("select",{"data-key":"parameters"},Object.entries({selected:"selected row",all:"all rows",none:"none"}).map(([f,p])=>z("option",{value:f},p)));m.addEventListener("change",()=>n.setShown({parameters:m.value}));let g=e.isMounted?"placement":"D-H parameters";if(c.append(z("label",{class:"choice"},z("span",{},g),m)),e.tips.length>1){let f=z("select",{"data-key":"tip"},e.tips.map(({name:p},M)=>z("option",{value:M},p)));f.addEventListener("change",()=>n.setTip(Number(f.value))),c.append(z("label",{class:"choice"},z("span",{},"frame"),f))}let x={frames:"frames",axes:"axes",masses:"masses",trace:"trace"};e.floating&&(x.isFollowed="follow the fall");for(let[f,p]of Object.entries(x)){let M=z("input",{type:"checkbox",checked:t.show[f],"data-key":`show-${f}`});M.addEventListener("change",()=>n.setShown({[f]:M.checked})),c.append(z("label",{class:"check"},M,p))}return{section:d,start:u}}var cT={theta:"\u03B8",d:"d",a:"a",alpha:"\u03B1"},hT={standard:["theta","d","a","alpha"],modified:["alpha","a","d","theta"]},ur=(n,e=4)=>n.map(t=>pt(t,e)).join(", ");function q_(n){let{table:e,state:t}=n,i=cr(e),s=e.isMounted?["xyz","rpy","axis"]:hT[e.convention],r=e.rows.some(v=>v.limits),o=e.rows.some(v=>v.gearRatio!==0&&v.motorInertia!==0),a=e.rows.some(v=>v.viscous||v.coulomb.some(Boolean)||v.stribeck||v.spring),l=z("input",{type:"checkbox","data-key":"bodies"}),c=z("thead"),h=z("tbody"),d=z("caption");function u(){let{angleUnit:v}=n.units,D=E=>e.convention==="modified"&&(E==="a"||E==="alpha"),C=s.map(E=>{if(e.isMounted){let O={xyz:"m",rpy:v,axis:""}[E];return z("th",{scope:"col"},E," ",z("span",{class:"unit"},O))}let L=z("span",{class:"swatch"});L.style.background=hr[E];let F=E==="a"||E==="d"?"m":v,I=dn(cT[E],D(E)?"i\u22121":"i");return z("th",{scope:"col"},L,I," ",z("span",{class:"unit"},F))});r&&C.push(z("th",{scope:"col"},"limits")),C.push(z("th",{scope:"col"},"mass ",z("span",{class:"unit"},"kg"))),l.checked&&(C.push(z("th",{scope:"col"},"centre of mass ",z("span",{class:"unit"},"m"))),C.push(z("th",{scope:"col"},"inertia xx, yy, zz, xy, yz, xz ",z("span",{class:"unit"},"kg m\xB2"))),o&&C.push(z("th",{scope:"col"},"motor")),a&&C.push(z("th",{scope:"col"},"friction, spring"))),c.replaceChildren(z("tr",{},z("th",{scope:"col"},"joint"),C))}function m(v){if(v.joint!==null)return dn("q",v.joint+1);if(!v.follows)return null;let{joint:D,factor:C,offset:E}=v.follows,L=C===1?"":C===-1?"-":`${pt(C)} `,F=E===0?"":` ${E<0?"-":"+"} ${pt(Math.abs(E))}`;return[L,...dn("q",D+1),F]}function g(v,D){let{cell:C}=n.units;if(e.isMounted){let{places:k,axis:K}=v.mount,Y=dp(k),[Z,te]=K,le=[Math.sin(te)*Math.cos(Z),Math.sin(te)*Math.sin(Z),Math.cos(te)],ce={xyz:ur(Y.xyz),rpy:Y.rpy.map(C).join(", "),axis:ur(le.map(ee=>Math.abs(ee)<1e-12?0:ee))};return z("td",{},D==="axis"&&v.isPlace?"":ce[D])}let E=D==="theta"||D==="alpha",L=E?C(v[D]):pt(v[D],6),F=v.text[D],I=D===(v.type==="prismatic"?"d":"theta"),O=I?m(v):null,V=F?[z("i",{},F),z("span",{class:"unit"},` = ${L}`)]:[L];if(O)return z("td",{class:"variable"},O,v[D]===0&&!F?null:[" + ",V]);if(I&&v.locked!==null&&!v.isPlace){let k=v[D]+v.locked;return z("td",{},E?C(k):pt(k,6)," ",z("span",{class:"kind"},"locked"))}return z("td",{},V)}function x(v){let{viscous:D,coulomb:C,stribeck:E,spring:L}=v,F=C[0]===C[1];return[D?`viscous ${pt(D)}`:null,C.some(Boolean)?`Coulomb ${F?pt(C[0]):`+${pt(C[0])} / -${pt(C[1])}`}`:null,E?`static ${pt(E.friction)} below ${pt(E.velocity)}`:null,L?`spring ${pt(L.stiffness)} at ${pt(L.rest)}`:null].filter(Boolean).join(", ")}let f=({xyz:v,rpy:D})=>`xyz ${ur(v)} m, rpy ${D.map(n.units.cell).join(", ")} ${n.units.angleUnit}`,p=v=>v===null?"the base":e.rows[v].name;function M(v,D){return v.follows?e.isMounted?["follows ",m(D)]:"follows":v.locked===null?v.type:e.isMounted?`locked at ${pt(D.locked*n.units.factor(v.type))} ${n.units.position(v.type)}`:"locked"}function P({row:v,index:D}){let C=n.table.rows[D],{factor:E,position:L}=n.units,F=v.joint??v.follows?.joint,I=z("th",{scope:"row"});if(v.isPlace)I.append("tip");else{let V=z("button",{type:"button",class:"name",onclick:()=>n.select(D)});V.append(z("span",{class:"dot"}),v.name||"fixed"," "),V.append(z("span",{class:"kind"},M(v,C))),(v.on??-1)!==D-1&&V.append(z("span",{class:"kind"},` on ${p(v.on)}`));let k=e.isMounted?[]:C.step.map(K=>`, at ${f(K)}`);V.append(z("span",{class:"kind"},...k)),I.append(V)}I.style.setProperty("--color",F===void 0?"var(--muted)":`var(--joint-${F%8})`);let O=s.map(V=>g(C,V));if(r){let V=E(v.type),k=C.limits?.map(K=>pt(K*V));O.push(z("td",{},k?`${k[0]} \u2026 ${k[1]} ${L(v.type)}`:""))}if(O.push(z("td",{},C.text.mass?[z("i",{},C.text.mass),` = ${pt(C.mass)}`]:pt(C.mass))),l.checked){O.push(z("td",{},ur(C.com)),z("td",{},ur(C.inertia)));let{motorInertia:V,gearRatio:k}=C;o&&O.push(z("td",{},V?`${pt(V)} kg m\xB2 \xD7 ${pt(k)}\xB2`:"")),a&&O.push(z("td",{},x(C)))}return z("tr",{"data-row":D},I,O)}function y(v,D,C){let E=[z("td",{colSpan:s.length+(r?1:0)},f(D)),z("td",{},C)];return l.checked&&E.push(z("td",{colSpan:4},D.com?ur(D.com):"")),z("tr",{class:"placed"},z("th",{scope:"row"},v),E)}function A({mass:v,com:D,inertia:C}){let E=[z("td",{colSpan:s.length+(r?1:0)},"moves freely"),z("td",{},pt(v))];return l.checked&&E.push(z("td",{},ur(D)),z("td",{},ur(C))),z("tr",{class:"placed"},z("th",{scope:"row"},"base"),E)}function b(){let{base:v,floating:D,tool:C}=n.table;u();let E=i.map(P);v&&E.unshift(y("base",v,"")),D&&E.unshift(A(D)),C&&E.push(y("tool",C,pt(C.mass)));for(let{name:L,on:F,places:I,body:O}of n.table.tips.filter(V=>V.isFrame&&V.places.length===1))E.push(y(`${L} on ${p(F)}`,{...I[0],com:O?.com},O?pt(O.mass):""));h.replaceChildren(...E),d.textContent=e.isMounted?"Joints as the file places them":`Denavit-Hartenberg table, ${e.convention} convention`,_()}function _(){for(let v of h.children)v.classList.toggle("selected",Number(v.dataset.row)===t.selected)}return l.addEventListener("change",b),n.on("fields units",b),n.on("selection",_),b(),z("section",{class:"panel table","aria-label":"Table"},Pi("Table of the arm",z("table",{class:"cells"},d,c,h)),z("label",{class:"check"},l,"bodies, motors, friction"))}var Hf=["auto","light","dark"];function uT({floating:n,convention:e,isMounted:t,gravity:i},s){let r=s.map(({type:h})=>h==="revolute"?"R":"P").join(""),o=i.map(h=>pt(h)).join(", "),a=t?"joints of a URDF file":`${e} D-H table`,l=n?["a base that moves"]:[],c=s.length===0?[]:[`${s.length} ${s.length===1?"joint":"joints"} (${r})`,a];return[...l,...c,`gravity (${o}) m/s\xB2`].join(", ")}function dT(n){let e=z("button",{type:"button",class:"quiet","data-key":"theme"}),t=0,i=()=>{document.documentElement.dataset.theme=Hf[t],e.textContent=`Colors: ${Hf[t]}`};e.addEventListener("click",()=>{t=(t+1)%Hf.length,i(),n.tell("theme")}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>n.tell("theme")),i();let s=z("button",{type:"button",class:"quiet","data-key":"units"}),r=()=>s.textContent=`Angles: ${n.units.inDegrees?"degrees":"radians"}`;return s.addEventListener("click",()=>n.setUnits(!n.units.inDegrees)),n.on("units",r),r(),z("header",{},z("div",{},z("h1",{},n.table.name),z("p",{class:"said"},uT(n.table,n.joints))),z("div",{class:"switches"},s,e))}var Vr=em(globalThis.robotTable,globalThis.robotEquations,globalThis.robotStart),Y_=X_(Vr),$_=Ag(Vr);document.getElementById("page").append(dT(Vr),z("main",{},z("div",{class:"column fixed"},Y_.section,q_(Vr)),z("div",{class:"column"},Ep(Vr),bp(Vr),$_.section)),z("footer",{},"M, V, G, \u03C4 and the motion are computed in this page by functions that robot-dynamics has proven equal to the textbook Lagrangian. SI units."));Y_.start();$_.build();globalThis.robotPage=Vr;document.documentElement.dataset.ready="true";
